// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/aims.h"

#include <algorithm>
#include <cmath>

namespace dewbow::caustics {

namespace {

/// Rays begin this much farther out than the farthest thing, as a share of its distance.
constexpr double kFartherOut = 0.01;
/// Looks at one pair of lamp and group, and about how many at all of them: half a second.
constexpr std::size_t kMostLooks = 64, kLeastLooks = 2, kLooksInAll = 250'000;

}  // namespace

Outside::Outside(const Scene& scene) {
    const Bounds all = bounds_of(scene);
    ball_ = all.empty() ? Ball{{}, 0.0} : Ball{all.centre(), all.radius()};
    for (const Shape& shape : scene.shapes)
        if (std::holds_alternative<Plane>(shape.geometry))
            planes_.push_back({shape.world_from_object(Point<Object>{}).v,
                               shape.world_from_object(Normal<Object>{{0, 0, 1}}).v, 0.0});
}

Vec3 Outside::before(Vec3 point, Vec3 direction) const {
    double back = std::max(0.0, dot(point - ball_.centre, direction) + ball_.radius);
    for (const EndlessPlane& plane : planes_) {
        const double cosine = dot(direction, plane.normal);
        if (cosine == 0.0) continue;
        back = std::max(back, dot(point - plane.point, plane.normal) / cosine);
    }
    return point - direction * (back * (1.0 + kFartherOut));
}

Aims::Aims(const Scene& scene, const Casters& casters, std::size_t lamps)
    : groups(casters.groups()), index(casters.groups()), outside(scene) {
    const std::size_t pairs = std::max<std::size_t>(1, lamps * groups.size());
    looks = int(std::clamp(kLooksInAll / pairs, kLeastLooks, kMostLooks));
}

}  // namespace dewbow::caustics
