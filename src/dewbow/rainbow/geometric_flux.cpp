// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/geometric_flux.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

constexpr Angle kHalfTurn = std::numbers::pi * unit::rad;

/// ε² of both polarisations, from c = cos i alone.
PolarisedFlux transmitted(double c, double n, int p) {
    const double n_cos_r = std::sqrt(n * n - 1.0 + c * c);
    const double rs = (c - n_cos_r) / (c + n_cos_r);
    const double rp = (n * n * c - n_cos_r) / (n * n * c + n_cos_r);
    const auto left = [p](double R) {
        if (p == 0) return R;
        double T = (1.0 - R) * (1.0 - R);
        for (int reflection = 1; reflection < p; ++reflection) T *= R;
        return T;
    };
    return {left(rs * rs), left(rp * rp)};
}

/// Nodes enough to lose less than 1e-14 on an interval of cos i or i.
const QuadratureRule& rule_for(double length) {
    static const QuadratureRule few = gauss_legendre(3), some = gauss_legendre(5),
                                many = gauss_legendre(48);
    return length < 0.001 ? few : length < 0.01 ? some : many;
}

/// ∫ ε² 2b db = ∫ ε² 2c dc between two angles of incidence, `from` the smaller.
/// The integrand is smooth in c: its nearest poles are at c = −1 / √(n² + 1), that of the Brewster
/// angle behind the axis.
PolarisedFlux flux_over_disc(const RaySearch::Ray& from, const RaySearch::Ray& to, double n,
                             int p) {
    // c_from − c_to, without what cancels near the axis.
    const double length =
        from.sine < 0.7 ? (to.sine - from.sine) * (to.sine + from.sine) / (to.cosine + from.cosine)
                        : from.cosine - to.cosine;
    const double half = 0.5 * length;
    const QuadratureRule& rule = rule_for(length);
    PolarisedFlux sum;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double c = to.cosine + half * (1.0 + rule.nodes[k]);
        const PolarisedFlux left = transmitted(c, n, p);
        sum.perpendicular += rule.weights[k] * 2.0 * c * left.perpendicular;
        sum.parallel += rule.weights[k] * 2.0 * c * left.parallel;
    }
    return {half * sum.perpendicular, half * sum.parallel};
}

/// ∫ ε² db = ∫ ε² cos i di.
PolarisedFlux flux_over_impact(const RaySearch::Ray& from, const RaySearch::Ray& to, double n,
                               int p) {
    const double half = 0.5 * (to.incidence - from.incidence);
    const QuadratureRule& rule = rule_for(2.0 * half);
    PolarisedFlux sum;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double c = std::cos(from.incidence + half * (1.0 + rule.nodes[k]));
        const PolarisedFlux left = transmitted(c, n, p);
        sum.perpendicular += rule.weights[k] * c * left.perpendicular;
        sum.parallel += rule.weights[k] * c * left.parallel;
    }
    return {half * sum.perpendicular, half * sum.parallel};
}

/// Share of a shift that acts at an angle, and its derivative per radian: 0 at 0° and 180°, 1 from
/// 30° to 150°.
struct Taper {
    double value, slope;
};
Taper taper(Angle theta) {
    constexpr Angle kWidth = 30.0 * unit::deg;
    const bool forward = theta < kHalfTurn - theta;
    const double u = std::clamp((forward ? theta : kHalfTurn - theta) / kWidth, 0.0, 1.0);
    const double slope = 6.0 * u * (1.0 - u) / kWidth.to(unit::rad);
    return {u * u * (3.0 - 2.0 * u), forward ? slope : -slope};
}

}  // namespace

std::vector<Angle> cell_edges(std::span<const Angle> theta) {
    for (std::size_t k = 0; k < theta.size(); ++k) {
        const double deg = theta[k].to(unit::deg);
        if (!(theta[k] >= Angle{} && theta[k] <= kHalfTurn))
            throw InputError(fmt::format("scattering angle {}°; expected 0 to 180°", deg));
        if (k > 0 && !(theta[k] > theta[k - 1]))
            throw InputError(fmt::format("scattering angle {}° after {}°; expected ascending ones",
                                         deg, theta[k - 1].to(unit::deg)));
    }
    std::vector<Angle> edges = {Angle{}};
    for (std::size_t k = 1; k < theta.size(); ++k) edges.push_back(0.5 * (theta[k - 1] + theta[k]));
    edges.push_back(kHalfTurn);
    return edges;
}

SolidAngle cell_solid_angle(Angle from, Angle to) {
    return 4.0 * std::numbers::pi * sin(0.5 * (from + to)) * sin(0.5 * (to - from)) * unit::sr;
}

void add_geometric_flux(RelativeIndex n, int p, std::span<const Angle> edges,
                        std::span<PolarisedFlux> out, RayDensity density) {
    const auto flux_between =
        density == RayDensity::even_over_disc ? flux_over_disc : flux_over_impact;
    for (const RayBranch& branch : ray_branches(n, p)) {
        RaySearch search(branch);
        const auto ray_at = [&](Angle theta) {
            return search.at(std::clamp(theta, branch.least, branch.greatest));
        };
        const auto first = std::upper_bound(edges.begin(), edges.end(), branch.least);
        std::size_t cell = first == edges.begin() ? 0 : std::size_t(first - edges.begin()) - 1;
        if (cell + 1 >= edges.size()) continue;
        RaySearch::Ray before = ray_at(edges[cell]);
        for (; cell + 1 < edges.size() && edges[cell] < branch.greatest; ++cell) {
            const RaySearch::Ray after = ray_at(edges[cell + 1]);
            const PolarisedFlux flux = before.incidence < after.incidence
                                           ? flux_between(before, after, n.value, p)
                                           : flux_between(after, before, n.value, p);
            out[cell].perpendicular += flux.perpendicular;
            out[cell].parallel += flux.parallel;
            before = after;
        }
    }
}

OrderFlux order_flux(RelativeIndex n, int p) {
    ray_branches(n, p);  // refuses what has none
    static const QuadratureRule rule = gauss_legendre(64);
    OrderFlux sum;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double c = 0.5 * (1.0 + rule.nodes[k]), weight = rule.weights[k] * c;
        const PolarisedFlux T = transmitted(c, n.value, p);
        const double cosine = cos(deviation(drop_ray(std::sqrt(1.0 - c * c), n), p));
        sum.flux.perpendicular += weight * T.perpendicular;
        sum.flux.parallel += weight * T.parallel;
        sum.flux_times_cosine.perpendicular += weight * cosine * T.perpendicular;
        sum.flux_times_cosine.parallel += weight * cosine * T.parallel;
    }
    return sum;
}

Angle angle_without_shift(Angle theta, Angle shift) {
    return std::clamp(theta - taper(theta).value * shift, Angle{}, kHalfTurn);
}

double brightness_of_shift(Angle theta, Angle shift) {
    const double s = shift.to(unit::rad), slope = 1.0 - taper(theta).slope * s;
    // At the ends, where the taper ends in zero with its slope, the ratio of the sines is 1.
    const double sine = sin(theta);
    const double ratio = sine < 1e-9 ? 1.0 : sin(angle_without_shift(theta, shift)) / sine;
    return std::max(ratio * slope, 0.0);
}

}  // namespace dewbow
