// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/uniform_bow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

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
/// Below this x sin θ the light that meets on the axis is no sum of rays.
constexpr double kOnAxis = 4.0;

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

/// P + (i/x) P_next and Q + (i/x) Q_next of one polarisation.
struct Factors {
    double P, Q, P_next = 0.0, Q_next = 0.0;

    Complex times(const AiryPair& ai, double per_x) const {
        return {P * ai.value - per_x * Q_next * ai.derivative,
                Q * ai.derivative + per_x * P_next * ai.value};
    }
};

/// With what 1/x has: P_next and Q_next, the second terms of P_n(cos θ) and its derivatives, and
/// what S_1 has of a_n π_n beside b_n τ_n.
Factors with_next(const PairAmplitude<double>& own, const PairAmplitude<double>& other, int side,
                  double theta) {
    const double sine = std::sin(theta);
    const double a = 0.875 * side * std::cos(theta) / sine, c = -side / sine;
    return {own.P, own.Q, own.P_next + a * own.P_over_b + c * other.P_over_b,
            own.Q_next + a * own.Q_over_b + c * other.Q_over_b};
}

/// What a passage has for drops of every size.
struct Light {
    double zeta, path;
    double still;   ///< the phase that does not depend on x
    double spread;  ///< stands for 1 / sin θ
    /// Below these x the light meets on the axis, and the terms in 1/x do not count.
    double on_axis, length;
    Factors perpendicular, parallel;

    /// @param third  x^{1/3}.   @param ai  at -ζ x^{2/3}, where the table has it.
    Amplitudes amplitudes(double x, double third, AiryPair ai) const {
        const double far = zeta * third * third;
        if (far < -kDarkest) return {};
        if (x < on_axis) return {kNaN, kNaN};
        if (far > -AiryTable::kLowest) return of_plain_ray(x);
        const double per_x = length < x ? fade(length, x) / x : 0.0;
        ai = {ai.value / third, ai.derivative / (third * third)};
        const Complex scale =
            -x * std::sqrt(2.0 * kPi * x * spread) * std::polar(1.0, x * path + still);
        return {scale * perpendicular.times(ai, per_x), scale * parallel.times(ai, per_x)};
    }

private:
    /// So far from the bow there is only a lone ray, and P Ai + i Q Ai' is a wave but for 1e-5.
    Amplitudes of_plain_ray(double x) const {
        const double root = std::sqrt(zeta), phase = x * (path - zeta * root / 1.5) + still;
        const Complex scale =
            -x * std::sqrt(2.0 * spread / root) * std::polar(1.0, phase + 0.25 * kPi);
        return {scale * perpendicular.P, scale * parallel.P};
    }
};

/// Passages that wait until there is a block of them.
struct Waiting {
    std::size_t count = 0;
    Block deviations{}, thetas{}, brightness{};
    std::array<Passage, kBlock> ways;
    std::array<std::size_t, kBlock> targets{};
};

PairAmplitude<double> at(const PairAmplitude<Block>& a, std::size_t i) {
    return {a.P[i], a.Q[i], a.P_over_b[i], a.Q_over_b[i], a.P_next[i], a.Q_next[i]};
}

/// Adds the light of drops that turn it by the same shift.
class ShiftedSum {
public:
    /// Into sums[drop][angle], of which each row has `angles`.
    ShiftedSum(const RayPairSeries& series, std::span<const Drop> drops, std::size_t angles,
               std::span<Amplitudes> sums)
        : series_(series), bow_(series.geometry()), drops_(drops), angles_(angles), sums_(sums) {}

    /// @param theta  where the light would go if the drops were spheres.
    /// @param brightness  of |S|², because they are none.
    void add(double theta, double brightness, std::size_t target) {
        for_each_passage(bow_, series_.darkest(), theta, [&](const Passage& way) {
            Waiting& those = way.deviation < bow_.grazing() ? pairs_ : lone_;
            const std::size_t i = those.count++;
            those.deviations[i] = way.deviation, those.thetas[i] = theta;
            those.brightness[i] = brightness;
            those.ways[i] = way, those.targets[i] = target;
            if (those.count == kBlock) flush(those);
        });
    }
    void finish() {
        flush(pairs_);
        flush(lone_);
    }

private:
    void flush(Waiting& those) {
        const bool have_two = &those == &pairs_;
        const RayPair<Block> pair = have_two ? series_.pairs(those.deviations, those.count)
                                             : series_.lone(those.deviations, those.count);
        std::array<Light, kBlock> light;
        for (std::size_t i = 0; i < those.count; ++i) light[i] = light_of(those, i, pair, have_two);
        Block arguments, value, derivative;
        for (std::size_t d = 0; d < drops_.size(); ++d) {
            const double x = drops_[d].size_parameter, third = std::cbrt(x);
            for (std::size_t i = 0; i < those.count; ++i)
                arguments[i] = std::clamp(-light[i].zeta * third * third, AiryTable::kLowest,
                                          AiryTable::kHighest);
            AiryTable::instance().eval(std::span(arguments).first(those.count), value, derivative);
            for (std::size_t i = 0; i < those.count; ++i) {
                const Amplitudes s = light[i].amplitudes(x, third, {value[i], derivative[i]});
                Amplitudes& sum = sums_[d * angles_ + those.targets[i]];
                sum.perpendicular += s.perpendicular;
                sum.parallel += s.parallel;
            }
        }
        those.count = 0;
    }

    Light light_of(const Waiting& those, std::size_t i, const RayPair<Block>& pair,
                   bool have_two) const {
        const Passage& way = those.ways[i];
        const double theta = those.thetas[i], D = way.deviation;
        const PairAmplitude<double> s = at(pair.perpendicular, i), p = at(pair.parallel, i);
        Light light;
        light.zeta = pair.zeta[i], light.path = pair.path[i];
        // Of Poisson's sum, of R_11^{p-1} with the Hankel functions, and of P_n.
        light.still = kPi * (way.turns - 0.5 * (bow_.p - 1) - 0.25 * way.side);
        light.spread = those.brightness[i] * focus(bow_, D, theta);
        light.on_axis = is_central(bow_, D) ? 0.0 : kOnAxis / std::sin(theta);
        light.length = have_two ? fade_length(bow_, series_.sigma(D)) : kLargestBowSize;
        light.perpendicular = {s.P, s.Q}, light.parallel = {p.P, p.Q};
        if (light.length < kLargestBowSize) {
            light.perpendicular = with_next(s, p, way.side, theta);
            light.parallel = with_next(p, s, way.side, theta);
        }
        return light;
    }

    const RayPairSeries& series_;
    const BowGeometry& bow_;
    std::span<const Drop> drops_;
    std::size_t angles_;
    std::span<Amplitudes> sums_;
    Waiting pairs_, lone_;
};

}  // namespace

TwoRayRegion two_ray_region(RelativeIndex n, int p) {
    const BowGeometry bow = bow_geometry(n, p);
    const Angle at_bow = scattering_angle(bow.least * unit::rad);
    const Angle end = scattering_angle(bow.grazing() * unit::rad);
    return {end > at_bow ? Angle{} : kPi * unit::rad, at_bow, end};
}

void UniformBow::add_amplitudes(std::span<const Drop> drops, std::span<const Angle> theta,
                                std::span<Amplitudes> sums) const {
    const auto p = static_cast<std::size_t>(series_.geometry().p);
    for (std::size_t from = 0, to = 0; from < drops.size(); from = to) {
        const Angle shift = drops[from].shifts[p];
        while (to < drops.size() && drops[to].shifts[p] == shift) ++to;
        ShiftedSum sum(series_, drops.subspan(from, to - from), theta.size(),
                       sums.subspan(from * theta.size()));
        for (std::size_t i = 0; i < theta.size(); ++i)
            sum.add(angle_without_shift(theta[i], shift).to(unit::rad),
                    brightness_of_shift(theta[i], shift), i);
        sum.finish();
    }
}

}  // namespace dewbow
