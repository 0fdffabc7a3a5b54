// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/refract_lanes.h"

#include <cmath>

#include "dewbow/base/simd.h"

namespace dewbow {

namespace {

/// Grazing and beyond, by rounding: far from what would make the products below vanish.
constexpr double kLeastCosine = 1e-60;

}  // namespace

DEWBOW_SIMD void refract_or_reflect_lanes(int count, double u, const RayLanes& rays,
                                          BoundaryLanes& boundary) {
    // One division and one root a lane: they take nearly all of the time.
    for (int k = 0; k < count; ++k) {
        const auto i = std::size_t(k);
        const double nx = boundary.nx.v[i], ny = boundary.ny.v[i], nz = boundary.nz.v[i];
        const double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        const double eta = boundary.eta.v[i], inverse = 1.0 / eta;
        const double cosine = -(dx * nx + dy * ny + dz * nz);
        const double cos_i = cosine > kLeastCosine ? cosine : kLeastCosine;
        const double cos2_t = (eta * eta - 1.0 + cos_i * cos_i) * (inverse * inverse);
        const double cos_t = std::sqrt(cos2_t > 0.0 ? cos2_t : 0.0);
        // Fresnel's equations, R = ((s / s')² + (p / p')²) / 2, and u < R times 2 (s' p')². Beyond
        // the critical angle cos θ_t is 0, and R comes out as 1.  [Born & Wolf §1.5.2]
        const double s = (cos_i - eta * cos_t) * (eta * cos_i + cos_t);
        const double p = (eta * cos_i - cos_t) * (cos_i + eta * cos_t);
        const double whole = (cos_i + eta * cos_t) * (eta * cos_i + cos_t);
        const bool reflects = 2.0 * u * (whole * whole) < s * s + p * p;
        // d + 2 cos θ_i n, or d/η + (cos θ_i / η − cos θ_t) n.
        const double along = reflects ? 1.0 : inverse;
        const double across = reflects ? 2.0 * cos_i : cos_i * inverse - cos_t;
        const double x = along * dx + across * nx;
        const double y = along * dy + across * ny;
        const double z = along * dz + across * nz;
        // Its length is 1 but for rounding: one step of Newton's towards the inverse root.
        const double scale = 1.5 - 0.5 * (x * x + y * y + z * z);
        boundary.dx.v[i] = x * scale;
        boundary.dy.v[i] = y * scale;
        boundary.dz.v[i] = z * scale;
        boundary.reflected.v[i] = reflects ? 1.0 : 0.0;
    }
}

}  // namespace dewbow
