// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/polariser.h"

#include <cmath>

namespace dewbow {

Polariser::Polariser(Angle turned, const Transform<World, Camera>& world_from_camera, bool around)
    : cosine_(std::cos(turned.to(unit::rad))),
      sine_(std::sin(turned.to(unit::rad))),
      around_(around) {
    const auto world = [&](Vec3 v) { return normalised(world_from_camera(Dir<Camera>{v}).v); };
    up_ = world({0.0, 1.0, 0.0});
    axis_ = world({-sine_, cosine_, 0.0});  // x is to the right
}

double Polariser::perpendicular_share(Vec3 view, Vec3 to_sun) const {
    /// Sines below which the line of sight has no plane with the sun or the axis.
    constexpr double kAlong = 1e-12;
    Vec3 axis = axis_;
    if (around_) {
        const Vec3 left = cross(up_, view);
        axis = (up_ - view * dot(up_, view)) * cosine_ + left * sine_;
    }
    const Vec3 across = axis - view * dot(axis, view), tangent = cross(view, to_sun);
    const double squares = dot(across, across) * dot(tangent, tangent);
    if (squares < kAlong * kAlong) return kPolariserShare;
    const double along = dot(across, tangent);
    return along * along / squares;
}

}  // namespace dewbow
