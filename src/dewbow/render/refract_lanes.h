// SPDX-License-Identifier: Apache-2.0
#pragma once

// A packet of lanes at a smooth boundary, in SIMD: Snell, Fresnel, and the choice between
// reflection and refraction. The instruction set is chosen when the program starts; the results are
// the same bits on each.

#include "dewbow/render/lanes.h"
#include "dewbow/render/ray.h"

namespace dewbow {

struct BoundaryLanes {
    LaneValues nx, ny, nz;   ///< unit normals that face the rays
    LaneValues eta;          ///< n_t / n_i of each lane
    LaneValues reflectance;  ///< out: unpolarised
    LaneValues reflected;    ///< out: 1 if the lane was reflected, else 0
};

/// Fresnel's reflectance of each of the first `count` lanes, for the directions in `rays`.
void reflectance_lanes(int count, const RayLanes& rays, BoundaryLanes& boundary);

/// Turns the first `count` directions in `rays`: reflected where `u` is below the lane's
/// reflectance, refracted elsewhere, with the same `u` for all lanes.
void refract_or_reflect_lanes(int count, double u, RayLanes& rays, BoundaryLanes& boundary);

}  // namespace dewbow
