// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/refract_lanes.h"

#include <cmath>

#include "dewbow/base/simd.h"

namespace dewbow {

namespace {

/// Fresnel's equations for one lane, without a branch. Beyond the critical angle cos θ_t is 0 and
/// both reflectances come out as 1.  [Born & Wolf §1.5.2]
struct Interface {
    double cos_t, reflectance;
};
inline Interface interface_at(double cos_i, double eta) {
    const double cos2_t = (eta * eta - 1.0 + cos_i * cos_i) / (eta * eta);
    const double cos_t = std::sqrt(cos2_t > 0.0 ? cos2_t : 0.0);
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return {cos_t, 0.5 * (s * s + p * p)};
}

}  // namespace

DEWBOW_SIMD void refract_or_reflect_lanes(int count, double u, const RayLanes& rays,
                                          BoundaryLanes& boundary) {
    for (int k = 0; k < count; ++k) {
        const auto i = std::size_t(k);
        const double nx = boundary.nx.v[i], ny = boundary.ny.v[i], nz = boundary.nz.v[i];
        const double dx = rays.dx[i], dy = rays.dy[i], dz = rays.dz[i];
        const double eta = boundary.eta.v[i];
        const double cosine = -(dx * nx + dy * ny + dz * nz);
        const double cos_i = cosine > 1e-300 ? cosine : 1e-300;
        const Interface at = interface_at(cos_i, eta);
        const bool reflects = u < at.reflectance;
        // d + 2 cos θ_i n, or d/η + (cos θ_i / η − cos θ_t) n.
        const double inverse = 1.0 / eta;
        const double along = reflects ? 1.0 : inverse;
        const double across = reflects ? 2.0 * cos_i : cos_i * inverse - at.cos_t;
        const double x = along * dx + across * nx;
        const double y = along * dy + across * ny;
        const double z = along * dz + across * nz;
        const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
        boundary.dx.v[i] = x * scale;
        boundary.dy.v[i] = y * scale;
        boundary.dz.v[i] = z * scale;
        boundary.reflected.v[i] = reflects ? 1.0 : 0.0;
    }
}

}  // namespace dewbow
