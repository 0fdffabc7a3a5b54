// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/uniform_bow.h"

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "dewbow/math/airy.h"
#include "dewbow/rainbow/bow_passages.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/geometric_flux.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
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

/// [P + (i w/x) P'] x^{-1/3} Ai + i [Q + (i w/x) Q'] x^{-2/3} Ai' of one polarisation.
Complex pair_sum(double P, double Q, const NextTerms& next, double w_over_x, const AiryPair& ai) {
    return {P * ai.value - w_over_x * next.Q * ai.derivative,
            Q * ai.derivative + w_over_x * next.P * ai.value};
}

/// @param brightness  of |S|², because the drop has turned it (brightness_of_shift).
void add_passage(const RayPairSeries& series, const Passage& way, double theta, double brightness,
                 const Sums& sums) {
    const BowGeometry& bow = series.geometry();
    const RayPair<double> pair = series.at(way.deviation);
    const bool has_two = way.deviation < bow.grazing(), is_axial = is_central(bow, way.deviation);
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const double length = has_two ? fade_length(bow, series.sigma(way.deviation)) : kLargestBowSize;
    const NextTerms s(pair.perpendicular, pair.parallel, way.side, cosine, sine);
    const NextTerms p(pair.parallel, pair.perpendicular, way.side, cosine, sine);
    const double still = still_phase(bow.p, way),
                 spread = brightness * focus(bow, way.deviation, theta);
    sums.add([&](double x) -> Amplitudes {
        const double third = std::cbrt(x), two_thirds = third * third;
        if (-pair.zeta * two_thirds > kDarkest) return {};
        if (!is_axial && x * sine < kOnAxis) return {kNaN, kNaN};
        AiryPair ai = airy(-pair.zeta * two_thirds);
        ai = {ai.value / third, ai.derivative / two_thirds};
        const double w = length < x ? fade(length, x) / x : 0.0;
        const NextTerms none;
        const Complex scale =
            -x * std::sqrt(2.0 * kPi * x * spread) * std::polar(1.0, x * pair.path + still);
        return {
            scale * pair_sum(pair.perpendicular.P, pair.perpendicular.Q, w > 0.0 ? s : none, w, ai),
            scale * pair_sum(pair.parallel.P, pair.parallel.Q, w > 0.0 ? p : none, w, ai)};
    });
}

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
    const BowGeometry& bow = series_.geometry();
    for_each_shift(drops, bow.p, [&](std::size_t from, std::size_t count, Angle shift) {
        const Sums part{drops.subspan(from, count), sums.subspan(from, count)};
        const double theta = angle_without_shift(angle, shift).to(unit::rad);
        const double brightness = brightness_of_shift(angle, shift);
        for_each_passage(bow, series_.darkest(), theta, [&](const Passage& way) {
            add_passage(series_, way, theta, brightness, part);
        });
    });
}

}  // namespace dewbow
