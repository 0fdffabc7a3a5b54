// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which part of a ray lies where a lamp shines, or where a camera sees it.

#include <algorithm>

#include "dewbow/render/haze/distance_density.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// In the cone of directions from `apex` whose cosine with `axis`, unit, is at least `cosine` >= 0.
RayInterval part_in_cone(Vec3 origin, Vec3 direction, double length, Vec3 apex, Vec3 axis,
                         double cosine);
/// In the cylinder of `radius` m around `axis`, unit, that begins at the disc around `base`.
RayInterval part_in_cylinder(Vec3 origin, Vec3 direction, double length, Vec3 base, Vec3 axis,
                             double radius);

/// A ball around all shapes of a scene but planes without end.
struct BoundingBall {
    Vec3 centre;
    double radius = 0.0;  ///< m; 0: nothing is in it

    bool holds(Vec3 point) const { return length(point - centre) < radius; }
    RayInterval part(Vec3 origin, Vec3 direction) const;
};
BoundingBall ball_around(const Scene& scene);

/// What lies in both.
inline RayInterval common_part(RayInterval a, RayInterval b) {
    return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

}  // namespace dewbow
