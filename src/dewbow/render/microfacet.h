// SPDX-License-Identifier: Apache-2.0
#pragma once

// The GGX distribution of microfacets. Directions are in the local frame: z is the surface's
// normal. [Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007]

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// Roughness below this is a mirror within the precision of its density.
inline constexpr double kLeastAlpha = 1e-4;

/// Density of microfacet normals m (unit, m.z > 0), per steradian of projected area.
inline double ggx_d(Vec3 m, double alpha) {
    const double a2 = alpha * alpha;
    // (a² − 1) z² + 1, written so that it does not cancel at z = 1.
    const double k = a2 * m.z * m.z + m.x * m.x + m.y * m.y;
    return a2 / (std::numbers::pi * k * k);
}

/// Smith's shadowing of one direction.
inline double ggx_g1(Vec3 w, double alpha) {
    const double z2 = w.z * w.z;
    if (z2 <= 0.0) return 0.0;
    const double tan2 = (w.x * w.x + w.y * w.y) / z2;
    return 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * tan2));
}

/// Density with which sample_visible_normal picks m for `w`.
inline double ggx_visible_pdf(Vec3 w, Vec3 m, double alpha) {
    const double cosine = dot(w, m);
    if (cosine <= 0.0 || w.z <= 0.0) return 0.0;
    return ggx_g1(w, alpha) * cosine * ggx_d(m, alpha) / w.z;
}

/// A microfacet normal among those that `w` (w.z > 0) sees.
/// [Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4) 2018]
inline Vec3 sample_visible_normal(Vec3 w, double alpha, std::array<double, 2> u) {
    const Vec3 stretched = normalised({alpha * w.x, alpha * w.y, w.z});
    const Tangents frame = tangents_of(stretched);
    const DiscPoint p = sample_concentric_disc(u[0], u[1]);
    // Along the tangent that is orthogonal to z, the visible half disc is shifted and squeezed.
    const double side2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 t1 = side2 > 0.0 ? Vec3{-stretched.y, stretched.x, 0.0} / std::sqrt(side2) : frame.t;
    const Vec3 t2 = cross(stretched, t1);
    const double s = 0.5 * (1.0 + stretched.z);
    const double y = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - p.x * p.x)) + s * p.y;
    const double z = std::sqrt(std::max(0.0, 1.0 - p.x * p.x - y * y));
    const Vec3 m = t1 * p.x + t2 * y + stretched * z;
    return normalised({alpha * m.x, alpha * m.y, std::max(1e-9, m.z)});
}

}  // namespace dewbow
