// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/rainbow/mie/angular_kernel.h"

namespace dewbow {
namespace {

/// π − the double next to it.
constexpr double kPiRest = 1.2246467991473532e-16;
/// Angles from an axis, in radians, that count as one: a few roundings of an angle near π. At
/// x = 50,000 it changes phases by 5e-11.
constexpr double kSameAngle = 1e-15;

/// An angle from the nearer end of the axis, and the places of the directions of that angle in the
/// caller's list: around the forward end, around the backward end, or -1.
struct FoldedAngle {
    double from_axis = 0.0;
    int forward = -1, backward = -1;

    /// 1 − |cos θ| with all its digits.
    double off_axis() const {
        const double s = std::sin(0.5 * from_axis);
        return 2.0 * s * s;
    }
};

bool is_nearer(const FoldedAngle& a, const FoldedAngle& b) { return a.from_axis < b.from_axis; }

/// Folded at 90°: π_n and τ_n of 180° − θ are those of θ but for signs. First the pairs, then what
/// lies forward, then what lies backward.
std::vector<FoldedAngle> fold(std::span<const Angle> theta) {
    std::vector<FoldedAngle> forward, backward;
    for (std::size_t i = 0; i < theta.size(); ++i) {
        const double angle = theta[i].to(unit::rad);
        if (angle <= 0.5 * std::numbers::pi)
            forward.push_back({angle, int(i), -1});
        else
            backward.push_back({std::numbers::pi - angle + kPiRest, -1, int(i)});
    }
    std::reverse(backward.begin(), backward.end());
    for (auto* side : {&forward, &backward})
        if (!std::is_sorted(side->begin(), side->end(), is_nearer))
            std::sort(side->begin(), side->end(), is_nearer);
    std::vector<FoldedAngle> pairs, single_forward, single_backward;
    auto f = forward.begin(), b = backward.begin();
    while (f != forward.end() && b != backward.end())
        if (std::abs(f->from_axis - b->from_axis) <= kSameAngle)
            pairs.push_back({f->from_axis, f++->forward, b++->backward});
        else if (is_nearer(*f, *b))
            single_forward.push_back(*f++);
        else
            single_backward.push_back(*b++);
    for (auto [first, last] :
         {std::pair(single_forward.begin(), single_forward.end()), std::pair(f, forward.end()),
          std::pair(single_backward.begin(), single_backward.end()), std::pair(b, backward.end())})
        pairs.insert(pairs.end(), first, last);
    return pairs;
}

/// What a sphere's sums multiply π_n + τ_n and π_n − τ_n with.
struct Factors {
    std::vector<double> plus, minus;
    void reserve(std::size_t orders) {
        plus.reserve(2 * orders);
        minus.reserve(2 * orders);
    }
    void append(std::complex<double> p, std::complex<double> m) {
        plus.insert(plus.end(), {p.real(), p.imag()});
        minus.insert(minus.end(), {m.real(), m.imag()});
    }
    operator WaveFactors() const { return {plus, minus}; }
};

/// S_1 ± S_2 = Σ c_n (a_n ± b_n) (π_n ± τ_n) of the directions around the forward end.
Factors forward_factors(const PartialWaves& waves) {
    Factors factors;
    factors.reserve(waves.a.size());
    for (std::size_t i = 0; i < waves.a.size(); ++i) {
        const double n = double(i) + 1.0, c = (2.0 * n + 1.0) / (n * (n + 1.0));
        factors.append(c * (waves.a[i] + waves.b[i]), c * (waves.a[i] - waves.b[i]));
    }
    return factors;
}

/// At 180° − θ π_n gets the sign (−1)^{n+1} and τ_n the other: sums over π_n + τ_n are those of
/// S_1 − S_2 there, sums over π_n − τ_n those of S_1 + S_2.
Factors backward_factors(const Factors& forward) {
    Factors factors{forward.minus, forward.plus};
    for (std::vector<double>* part : {&factors.plus, &factors.minus})
        for (std::size_t i = 2; i < part->size(); i += 4) {
            (*part)[i] = -(*part)[i];
            (*part)[i + 1] = -(*part)[i + 1];
        }
    return factors;
}

/// The half sum of both sums at one angle, and their half difference.
struct HalfSums {
    std::complex<double> sum, difference;
    HalfSums(const BlockSums& sums, std::size_t angle)
        : sum(0.5 * (sums.plus[0][angle] + sums.minus[0][angle]),
              0.5 * (sums.plus[1][angle] + sums.minus[1][angle])),
          difference(0.5 * (sums.plus[0][angle] - sums.minus[0][angle]),
                     0.5 * (sums.plus[1][angle] - sums.minus[1][angle])) {}
};

/// Spheres and directions of one call.
class AngularSum {
public:
    AngularSum(std::span<const PartialWaves> spheres, std::span<Amplitudes> out, std::size_t angles)
        : spheres_(spheres.size()), angles_(angles), out_(out) {
        for (const PartialWaves& waves : spheres) forward_.push_back(forward_factors(waves));
        for (const Factors& forward : forward_) backward_.push_back(backward_factors(forward));
        factors_.reserve(2 * spheres_);
        sums_.resize(2 * spheres_);
    }

    /// Up to kBlockAngles angles.
    void sum(std::span<const FoldedAngle> block) {
        double epsilon[kBlockAngles];
        bool forward = false, backward = false;
        for (std::size_t i = 0; i < block.size(); ++i) {
            epsilon[i] = block[i].off_axis();
            forward |= block[i].forward >= 0;
            backward |= block[i].backward >= 0;
        }
        factors_.clear();
        if (forward) factors_.insert(factors_.end(), forward_.begin(), forward_.end());
        if (backward) factors_.insert(factors_.end(), backward_.begin(), backward_.end());
        sum_block(factors_, {epsilon, block.size()}, sums_);
        const std::size_t first_backward = forward ? spheres_ : 0;
        for (std::size_t s = 0; s < spheres_; ++s)
            for (std::size_t i = 0; i < block.size(); ++i) {
                if (block[i].forward >= 0) {
                    const HalfSums half(sums_[s], i);
                    at(s, block[i].forward) = {half.sum, half.difference};
                }
                if (block[i].backward >= 0) {
                    const HalfSums half(sums_[first_backward + s], i);
                    at(s, block[i].backward) = {half.sum, -half.difference};
                }
            }
    }

private:
    Amplitudes& at(std::size_t sphere, int angle) {
        return out_[sphere * angles_ + std::size_t(angle)];
    }

    std::size_t spheres_, angles_;
    std::span<Amplitudes> out_;
    std::vector<Factors> forward_, backward_;
    std::vector<WaveFactors> factors_;
    std::vector<BlockSums> sums_;
};

}  // namespace

void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out) {
    const std::vector<FoldedAngle> folded = fold(theta);
    AngularSum sum(spheres, out, theta.size());
    for (std::size_t i = 0; i < folded.size(); i += kBlockAngles)
        sum.sum(
            std::span(folded).subspan(i, std::min(std::size_t(kBlockAngles), folded.size() - i)));
}

}  // namespace dewbow
