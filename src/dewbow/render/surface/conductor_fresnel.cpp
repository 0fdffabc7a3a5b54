// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/conductor_fresnel.h"

#include <array>
#include <cmath>

#include "dewbow/base/simd.h"

namespace dewbow {
namespace {

/// Gauss's nodes for the interval [0, 1]. [Abramowitz & Stegun 1964, table 25.4]
constexpr std::array<double, 3> kNode{0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> kWeight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/// As fresnel_conductor in optics, without branches, so that lanes run in SIMD. With
/// q² = (a + ib)² = (n + ik)² − sin²θ:
///     R_s = ((c − a)² + b²) / ((c + a)² + b²),
///     R_p = R_s ((c a − s²)² + c² b²) / ((c a + s²)² + c² b²).             [Born & Wolf §14.2]
DEWBOW_SIMD void conductor_lanes(int count, double c, const LaneValues& n, const LaneValues& k,
                                 LaneValues& out) {
    const double s2 = (1.0 - c) * (1.0 + c);
    for (int lane = 0; lane < count; ++lane) {
        const auto i = std::size_t(lane);
        const double u = n.v[i] * n.v[i] - k.v[i] * k.v[i] - s2, v = 2.0 * n.v[i] * k.v[i];
        const double modulus = std::sqrt(u * u + v * v);
        const double a2 = 0.5 * (modulus + u), b2 = 0.5 * (modulus - u);
        const double a = std::sqrt(a2 > 0.0 ? a2 : 0.0);
        const double sum = c * c + modulus, twice = 2.0 * a * c;
        const double s = (sum - twice) / (sum + twice);
        const double ca = c * a, c2b2 = c * c * (b2 > 0.0 ? b2 : 0.0);
        const double less = (ca - s2) * (ca - s2) + c2b2, more = (ca + s2) * (ca + s2) + c2b2;
        out.v[i] = 0.5 * s * (1.0 + (more > 0.0 ? less / more : 1.0));
    }
}

}  // namespace

ConductorFresnel::ConductorFresnel(const Conductor& metal, const LaneSet& lanes,
                                   const LaneValues& outside)
    : count_(lanes.count) {
    metal.n->eval_lanes(lanes.lambdas(), n_.first(count_));
    metal.k->eval_lanes(lanes.lambdas(), k_.first(count_));
    for (int k = 0; k < count_; ++k) n_[k] /= outside[k], k_[k] /= outside[k];
}

void ConductorFresnel::at(double cosine, LaneValues& reflectance) const {
    conductor_lanes(count_, cosine, n_, k_, reflectance);
}

void ConductorFresnel::average(LaneValues& reflectance) const {
    std::array<LaneValues, kNode.size()> at_node;
    for (std::size_t i = 0; i < kNode.size(); ++i) at(std::sqrt(kNode[i]), at_node[i]);
    for (int k = 0; k < count_; ++k)
        reflectance[k] =
            kWeight[0] * at_node[0][k] + kWeight[1] * at_node[1][k] + kWeight[2] * at_node[2][k];
}

}  // namespace dewbow
