// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays and what they hit, alone and in packets. All in the world frame, metres, double precision.

#include <array>
#include <cstdint>
#include <limits>

#include "dewbow/math/vector.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// The surface that a ray starts on. It is left out by name and not by a distance: no offset, no
/// epsilon.
struct SurfaceFrom {
    int shape = -1;       ///< index into Scene::shapes, −1 = starts in free space
    int primitive = -1;   ///< triangle of a mesh, face of a polyhedron
    bool inward = false;  ///< whether the ray goes against the outward normal
};

struct Ray {
    Vec3 origin, direction;  ///< direction: unit
    SurfaceFrom from;
};

struct Hit {
    double t = std::numeric_limits<double>::infinity();
    int shape = -1;  ///< −1: nothing was hit
    int primitive = -1;
    double u = 0.0,
           v = 0.0;  ///< barycentric coordinates on a triangle: weights of vertices 1 and 2
    Vec3 normal;     ///< of the true geometry: unit, outward

    explicit operator bool() const { return shape >= 0; }
};

/// A set of lanes, bit k for lane k.
using LaneMask = std::uint32_t;

/// Rays of a packet, as a structure of arrays. Not initialised: set each lane below `count`.
struct RayLanes {
    int count = 0;
    alignas(64) std::array<double, kMaxLanes> ox, oy, oz, dx, dy, dz;
    std::array<SurfaceFrom, kMaxLanes> from;

    Vec3 origin(int k) const { return {ox[k], oy[k], oz[k]}; }
    Vec3 direction(int k) const { return {dx[k], dy[k], dz[k]}; }
    Ray ray(int k) const { return {origin(k), direction(k), from[k]}; }
    void set(int k, const Ray& ray) {
        ox[k] = ray.origin.x, oy[k] = ray.origin.y, oz[k] = ray.origin.z;
        dx[k] = ray.direction.x, dy[k] = ray.direction.y, dz[k] = ray.direction.z;
        from[k] = ray.from;
    }
};
using HitLanes = std::array<Hit, kMaxLanes>;

}  // namespace dewbow
