// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/haze_view.h"

#include <algorithm>
#include <cmath>

#include "dewbow/render/haze/lit_part.h"

namespace dewbow {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
/// Share of the points that goes to the whole ray, in the picture or not: what the film sees beyond
/// cone or cylinder (by the width of the lens, an eye of a pair, or the filter) is not starved.
constexpr double kEvenShare = 0.05;

}  // namespace

HazeView::HazeView(const CameraView& view, const Film& film, const CameraRays& camera)
    : eye_(camera.position()), axis_(camera.axis()) {
    if (std::holds_alternative<Panorama>(view.projection)) return;
    const bool parallel = std::holds_alternative<Orthographic>(view.projection);
    cosine_ = 1.0;
    double radius = 0.0;
    for (const double x : {0.0, double(film.width)})
        for (const double y : {0.0, double(film.height)}) {
            const Ray corner = camera.ray_through(x, y);
            cosine_ = std::min(cosine_, dot(corner.direction, axis_));
            radius = std::max(radius, length(corner.origin - eye_));
        }
    if (parallel) radius_ = radius;
}

RayInterval HazeView::seen_part(Vec3 origin, Vec3 direction) const {
    if (radius_) return part_in_cylinder(origin, direction, kForever, eye_, axis_, *radius_);
    if (cosine_ < 0.0) return {};
    return part_in_cone(origin, direction, kForever, eye_, axis_, cosine_);
}

DistanceDensity HazeView::density(Vec3 origin, Vec3 direction, RayInterval where,
                                  std::span<const double> extinction) const {
    DistanceDensity density(extinction);
    const RayInterval seen = common_part(where, seen_part(origin, direction));
    const Vec3 to_eye = eye_ - origin;
    const double centre = dot(to_eye, direction);
    if (radius_)
        density.add_attenuated(seen, 1.0);
    else
        density.add_equiangular(seen, centre, length(to_eye - direction * centre), 1.0);
    density.finish(where, kEvenShare);
    return density;
}

}  // namespace dewbow
