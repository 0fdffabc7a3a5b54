// SPDX-License-Identifier: Apache-2.0
#pragma once

// A packet of lanes at a smooth boundary, in SIMD: Snell, Fresnel, and the choice between
// reflection and refraction. The instruction set is chosen when the program starts; the results are
// the same bits on each.

#include "dewbow/render/lanes.h"
#include "dewbow/render/ray.h"

namespace dewbow {

struct BoundaryLanes {
    LaneValues nx, ny, nz;  ///< in: unit normals that face the rays
    LaneValues eta;         ///< in: n_t / n_i
    LaneValues dx, dy, dz;  ///< out: the new directions
    LaneValues reflected;   ///< out: 1 where the lane was reflected, else 0
};

/// The first `count` rays beyond the boundary: reflected where `u` is below the lane's own
/// reflectance (unpolarised), refracted elsewhere, with the same `u` for all lanes.
void refract_or_reflect_lanes(int count, double u, const RayLanes& rays, BoundaryLanes& boundary);

}  // namespace dewbow
