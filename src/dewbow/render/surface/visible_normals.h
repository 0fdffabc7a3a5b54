// SPDX-License-Identifier: Apache-2.0
#pragma once

// Quadrature over the microfacets that a direction sees, and over cosines: what tables of albedos
// are computed with. Deterministic.

#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/math/quadrature.h"
#include "dewbow/math/vector.h"
#include "dewbow/render/surface/table_axis.h"

namespace dewbow {

/// Grazing directions stand for cos θ = 0.
inline constexpr double kLeastCosine = 1e-6;

class VisibleNormals {
public:
    explicit VisibleNormals(int rings, int spokes)
        : rule_(gauss_legendre(rings)), spokes_(spokes) {}

    /// Calls visit(m, weight) with the weights of a density of visible GGX normals, which sum to 1.
    /// `w` lies in the plane y = 0 and what is integrated is the same on both sides of it.
    /// The normals are halfway between the stretched `w` and points of a spherical cap of even
    /// density; the cap's rim, where the tilted facets are, gets nodes by `alpha`.
    ///                [Dupuy & Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023]
    template <class Visit>
    void for_each(Vec3 w, double alpha, Visit&& visit) const {
        const Vec3 s = normalised({alpha * w.x, 0.0, w.z});
        const LogAxis axis(alpha);
        for (std::size_t i = 0; i < rule_.nodes.size(); ++i) {
            // v² = 1 − u: du = 2 v dv.
            const double v = axis.value(0.5 * (1.0 + rule_.nodes[i]));
            const double weight = rule_.weights[i] * v * axis.slope(v) / spokes_;
            const double z = v * v * (1.0 + s.z) - s.z;
            const double r = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
            for (int j = 0; j < spokes_; ++j) {
                const double phi = std::numbers::pi * (j + 0.5) / spokes_;
                const Vec3 h{r * std::cos(phi) + s.x, r * std::sin(phi), z + s.z};
                visit(normalised({alpha * h.x, alpha * h.y, std::max(1e-12, h.z)}), weight);
            }
        }
    }

private:
    QuadratureRule rule_;
    int spokes_;
};

/// Calls visit(μ, weight) so that Σ weight f(μ) = 2 ∫ f μ dμ over cosines μ from 0 to 1, for f that
/// is smooth within each of `parts` equal parts of LogAxis(alpha).
template <class Visit>
void integrate_over_cosines(std::size_t parts, double alpha, Visit&& visit) {
    static const QuadratureRule rule = gauss_legendre(4);
    const LogAxis cosines(alpha);
    const double width = 1.0 / double(parts);
    for (std::size_t i = 0; i < parts; ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const double mu = cosines.value((double(i) + 0.5 * (1.0 + rule.nodes[j])) * width);
            visit(mu, rule.weights[j] * width * cosines.slope(mu) * mu);
        }
}

}  // namespace dewbow
