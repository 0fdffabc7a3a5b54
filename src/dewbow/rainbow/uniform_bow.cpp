// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/uniform_bow.h"

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "dewbow/base/simd.h"
#include "dewbow/math/airy.h"
#include "dewbow/rainbow/bow_passages.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/geometric_flux.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
using Block = RayPairSeries::Block;
constexpr std::size_t kBlock = RayPairSeries::kBlock;
constexpr double kPi = std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Ai(10) = 1e-10: darker than this nothing is left.
constexpr double kDarkest = 10.0;
/// Below this x b sin θ the light that meets on the axis is no sum of rays.
constexpr double kOnAxis = 3.0;

/// The terms in 1/x count by (1 - length / x)², with length = kFade / cos³i and cos i of the ray
/// nearer to the edge, taken as that of the Descartes ray times σ². Tuned on the Debye series of
/// p = 2 to 5 at x = 300 to 5000.
constexpr double kFade = 3.0;
double fade_length(const BowGeometry& bow, double sigma) {
    const double cosine = std::cos(bow.incidence) * sigma * sigma;
    return kFade / (cosine * cosine * cosine);
}
double fade(double length, double x) {
    const double left = std::max(0.0, 1.0 - length / x);
    return left * left;
}

/// P and Q in 1/x: P_next and Q_next, the second terms of P_n(cos θ) and its derivatives, and what
/// S_1 has of a_n π_n beside b_n τ_n.
struct NextTerms {
    double P = 0.0, Q = 0.0;

    NextTerms() = default;
    NextTerms(const PairAmplitude<double>& own, const PairAmplitude<double>& other, int side,
              double cosine, double sine) {
        const double a = 0.875 * side * cosine / sine, c = -side / sine;
        P = own.P_next + a * own.P_over_b + c * other.P_over_b;
        Q = own.Q_next + a * own.Q_over_b + c * other.Q_over_b;
    }
};

/// Of Poisson's sum, of R_11^{p-1} with the Hankel functions, and of P_n: what does not depend on
/// x.
double still_phase(int p, const Passage& way) {
    return kPi * (way.turns - 0.5 * (p - 1) - 0.25 * way.side);
}

/// The drops and sums to which a passage adds.
struct Sums {
    std::span<const Drop> drops;
    std::span<Amplitudes> amplitudes;

    /// `amplitudes_of(x)` gives what a drop has.
    template <class Function>
    void add(const Function& amplitudes_of) const {
        for (std::size_t k = 0; k < drops.size(); ++k) {
            const Amplitudes s = amplitudes_of(drops[k].size_parameter);
            amplitudes[k].perpendicular += s.perpendicular;
            amplitudes[k].parallel += s.parallel;
        }
    }
};

void add_single_ray(const BowGeometry& bow, const Passage& way, double sine, const Sums& sums) {
    const SingleRay ray = single_ray(bow, way.deviation, sine);
    const bool is_axial = is_central(bow, way.deviation);
    const double still = still_phase(bow.p, way) + 0.25 * kPi;
    sums.add([&](double x) -> Amplitudes {
        if (!is_axial && x * ray.b * sine < kOnAxis) return {kNaN, kNaN};
        const Complex scale = -x * std::polar(1.0, x * ray.path + still);
        return {scale * ray.perpendicular, scale * ray.parallel};
    });
}

/// [P + (i w/x) P'] x^{-1/3} Ai + i [Q + (i w/x) Q'] x^{-2/3} Ai' of one polarisation.
Complex pair_sum(double P, double Q, const NextTerms& next, double w_over_x, const AiryPair& ai) {
    return {P * ai.value - w_over_x * next.Q * ai.derivative,
            Q * ai.derivative + w_over_x * next.P * ai.value};
}

void add_pair(const RayPairSeries& pairs, const Passage& way, double theta, const Sums& sums) {
    const BowGeometry& bow = pairs.geometry();
    const RayPair<double> pair = pairs.at(way.deviation);
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const double length = fade_length(bow, pairs.sigma(way.deviation));
    const NextTerms s(pair.perpendicular, pair.parallel, way.side, cosine, sine);
    const NextTerms p(pair.parallel, pair.perpendicular, way.side, cosine, sine);
    const double still = still_phase(bow.p, way), b = std::sin(bow.incidence);
    sums.add([&](double x) -> Amplitudes {
        const double third = std::cbrt(x), two_thirds = third * third;
        if (-pair.zeta * two_thirds > kDarkest) return {};
        if (x * b * sine < kOnAxis) return {kNaN, kNaN};
        AiryPair ai = airy(-pair.zeta * two_thirds);
        ai = {ai.value / third, ai.derivative / two_thirds};
        const double w = length < x ? fade(length, x) / x : 0.0;
        const NextTerms none;
        const Complex scale =
            -x * std::sqrt(2.0 * kPi * x / sine) * std::polar(1.0, x * pair.path + still);
        return {
            scale * pair_sum(pair.perpendicular.P, pair.perpendicular.Q, w > 0.0 ? s : none, w, ai),
            scale * pair_sum(pair.parallel.P, pair.parallel.Q, w > 0.0 ? p : none, w, ai)};
    });
}

/// |S_j|² as x^{7/3} square Ai² + x^{5/3} slope Ai'² + x product Ai Ai', by angle.
struct Form {
    Block square, slope, product;
};
/// Angles with two rays.
struct PairAngles {
    std::size_t count = 0;
    std::array<std::size_t, kBlock> target{};  ///< where their light goes
    Block zeta, fade_length;
    Form perpendicular, parallel;
};

/// Adds weight |S_j|² of one size to s and p.
DEWBOW_SIMD void add_size(const double* nodes, const PairAngles& a, double x, double weight,
                          Block& s, Block& p) {
    const double third = std::cbrt(x), two_thirds = third * third, per_x = 1.0 / x;
    const double of_square = weight * x * x * third, of_slope = weight * x * two_thirds,
                 of_product = weight * x;
    for (std::size_t i = 0; i < a.count; ++i) {
        const double argument = -a.zeta[i] * two_thirds;
        const AiryPair ai = AiryTable::interpolate(
            nodes, std::min(std::max(argument, AiryTable::kLowest), AiryTable::kHighest));
        const double left = std::max(0.0, 1.0 - a.fade_length[i] * per_x);
        const double square = of_square * ai.value * ai.value;
        const double slope = of_slope * ai.derivative * ai.derivative;
        const double product = of_product * left * left * ai.value * ai.derivative;
        s[i] += square * a.perpendicular.square[i] + slope * a.perpendicular.slope[i] +
                product * a.perpendicular.product[i];
        p[i] += square * a.parallel.square[i] + slope * a.parallel.slope[i] +
                product * a.parallel.product[i];
    }
}

/// Drops that turn light by the same shift, at some angles.
class ShiftedSum {
public:
    ShiftedSum(const RayPairSeries& pairs, std::span<const Drop> drops,
               std::span<const double> weights, std::span<Intensities> out)
        : pairs_(pairs), drops_(drops), weights_(weights), out_(out) {
        double cubes = 0.0, smallest = kLargestBowSize;
        for (std::size_t k = 0; k < drops.size(); ++k) {
            const double x = drops[k].size_parameter, w = weights[k] * x * x;
            squares_ += w, cubes += w * x;
            largest_ = std::max(largest_, x);
            smallest = std::min(smallest, x);
        }
        typical_ = squares_ > 0.0 ? cubes / squares_ : largest_;
        darkest_zeta_ = -kDarkest / std::pow(smallest, 2.0 / 3.0);
    }
    void add(double theta, std::size_t target) {
        const BowGeometry& bow = pairs_.geometry();
        for_each_passage(bow, pairs_.darkest(), theta, [&](const Passage& way) {
            if (way.deviation < bow.grazing()) {
                deviations_[waiting_] = way.deviation;
                ways_[waiting_] = way, thetas_[waiting_] = theta;
                targets_[waiting_] = target;
                if (++waiting_ == kBlock) flush();
                return;
            }
            const SingleRay ray = single_ray(bow, way.deviation, sine_beside_axis(theta));
            out_[target].perpendicular += squares_ * ray.perpendicular * ray.perpendicular;
            out_[target].parallel += squares_ * ray.parallel * ray.parallel;
        });
    }
    void flush() {
        const PairAngles angles = prepare();
        Block s{}, p{};
        for (std::size_t k = 0; k < drops_.size(); ++k)
            add_size(AiryTable::instance().data(), angles, drops_[k].size_parameter, weights_[k], s,
                     p);
        for (std::size_t i = 0; i < angles.count; ++i) {
            out_[angles.target[i]].perpendicular += s[i];
            out_[angles.target[i]].parallel += p[i];
        }
        waiting_ = 0;
    }

private:
    double sine_beside_axis(double theta) const {
        return std::hypot(std::sin(theta), 2.0 / (kPi * typical_));
    }
    PairAngles prepare() const {
        const RayPair<Block> pair = pairs_.at(deviations_, waiting_);
        PairAngles angles;
        for (std::size_t i = 0; i < waiting_; ++i) {
            if (pair.zeta[i] < darkest_zeta_) continue;
            const std::size_t to = angles.count++;
            angles.target[to] = targets_[i];
            angles.zeta[to] = pair.zeta[i];
            const double length = fade_length(pairs_.geometry(), pairs_.sigma(deviations_[i]));
            // Where the terms never count, they may have no limit.
            const bool counts = length < largest_;
            angles.fade_length[to] = counts ? length : largest_;
            fill(angles.perpendicular, to, i, counts, at(pair.perpendicular, i),
                 at(pair.parallel, i));
            fill(angles.parallel, to, i, counts, at(pair.parallel, i), at(pair.perpendicular, i));
        }
        return angles;
    }
    static PairAmplitude<double> at(const PairAmplitude<Block>& a, std::size_t i) {
        return {a.P[i], a.Q[i], a.P_over_b[i], a.Q_over_b[i], a.P_next[i], a.Q_next[i]};
    }
    void fill(Form& form, std::size_t to, std::size_t i, bool counts,
              const PairAmplitude<double>& own, const PairAmplitude<double>& other) const {
        const double sine = sine_beside_axis(thetas_[i]), scale = 2.0 * kPi / sine;
        form.square[to] = scale * own.P * own.P;
        form.slope[to] = scale * own.Q * own.Q;
        form.product[to] = 0.0;
        if (!counts) return;
        const NextTerms next(own, other, ways_[i].side, std::cos(thetas_[i]), sine);
        form.product[to] = 2.0 * scale * (own.Q * next.P - own.P * next.Q);
    }

    const RayPairSeries& pairs_;
    std::span<const Drop> drops_;
    std::span<const double> weights_;
    std::span<Intensities> out_;
    double squares_ = 0.0;                  ///< Σ w x²
    double largest_ = 0.0, typical_ = 0.0;  ///< of x
    double darkest_zeta_ = 0.0;

    std::size_t waiting_ = 0;
    Block deviations_, thetas_;
    std::array<Passage, kBlock> ways_;
    std::array<std::size_t, kBlock> targets_;
};

/// Calls `visit(first, count, shift)` for each run of drops that turn light of order p alike.
template <class Visit>
void for_each_shift(std::span<const Drop> drops, int p, const Visit& visit) {
    const auto order = static_cast<std::size_t>(p);
    for (std::size_t from = 0, to = 0; from < drops.size(); from = to) {
        const Angle shift = drops[from].shifts[order];
        while (to < drops.size() && drops[to].shifts[order] == shift) ++to;
        visit(from, to - from, shift);
    }
}

}  // namespace

TwoRayRegion two_ray_region(RelativeIndex n, int p) {
    const BowGeometry bow = bow_geometry(n, p);
    const Angle at_bow = scattering_angle(bow.least * unit::rad);
    const Angle end = scattering_angle(bow.grazing() * unit::rad);
    return {end > at_bow ? Angle{} : kPi * unit::rad, at_bow, end};
}

void UniformBow::add_amplitudes(std::span<const Drop> drops, Angle angle,
                                std::span<Amplitudes> sums) const {
    const BowGeometry& bow = pairs_.geometry();
    for_each_shift(drops, bow.p, [&](std::size_t from, std::size_t count, Angle shift) {
        const Sums part{drops.subspan(from, count), sums.subspan(from, count)};
        const double theta = angle_without_shift(angle, shift).to(unit::rad);
        for_each_passage(bow, pairs_.darkest(), theta, [&](const Passage& way) {
            if (way.deviation < bow.grazing())
                add_pair(pairs_, way, theta, part);
            else
                add_single_ray(bow, way, std::sin(theta), part);
        });
    });
}

void UniformBow::add_intensities(std::span<const Drop> drops, std::span<const double> weights,
                                 std::span<const Angle> theta, std::span<Intensities> out) const {
    for (const Drop& drop : drops) check_bow_size(drop.size_parameter);
    for_each_shift(
        drops, pairs_.geometry().p, [&](std::size_t from, std::size_t count, Angle shift) {
            ShiftedSum sum(pairs_, drops.subspan(from, count), weights.subspan(from, count), out);
            for (std::size_t i = 0; i < theta.size(); ++i)
                sum.add(angle_without_shift(theta[i], shift).to(unit::rad), i);
            sum.flush();
        });
}

}  // namespace dewbow
