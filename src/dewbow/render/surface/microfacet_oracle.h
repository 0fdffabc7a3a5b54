// SPDX-License-Identifier: Apache-2.0
#pragma once

// For tests: means over the microfacets that a direction sees, drawn by their area and not by what
// is seen of it, on a grid of its own.

#include <cmath>
#include <numbers>

#include "dewbow/render/microfacet.h"

namespace dewbow::oracle {

/// Its own error, found by halving its steps.
inline constexpr double kError = 3e-4;

inline Vec3 tilted(double cosine) { return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}; }

/// ∫ D(m) (wo·m)+ g(m) dm G1(wo) / cos θ_o for a `g` that is alike on both sides of y = 0.
/// tan² θ_m = alpha² u / (1 − u) has even density in u.   [Walter et al. 2007, eq. 35]
template <class Function>
double mean_over_visible(Vec3 wo, double alpha, Function&& g) {
    constexpr int kRings = 1000, kSpokes = 100;
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        // Fine near u = 1, where facets are steep: 1 − u = v².
        const double v = (i + 0.5) / kRings, u = 1.0 - v * v;
        const double tangent = alpha * std::sqrt(u) / v;
        const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), r = tangent * z;
        for (int j = 0; j < kSpokes; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kSpokes;
            const Vec3 m{r * std::cos(phi), r * std::sin(phi), z};
            const double cosine = dot(wo, m);
            if (cosine > 0.0) sum += 2.0 * v * cosine / z * g(m);
        }
    }
    return sum / (double(kRings) * kSpokes) * ggx_g1(wo, alpha) / wo.z;
}

}  // namespace dewbow::oracle
