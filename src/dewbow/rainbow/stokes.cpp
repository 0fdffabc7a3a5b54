// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/stokes.h"

#include <cmath>

namespace dewbow {

Stokes stokes_of(const Intensities& scattered, Angle tangent) {
    const double q = 0.5 * (scattered.perpendicular - scattered.parallel);
    return {scattered.unpolarised(), q * cos(2.0 * tangent), q * sin(2.0 * tangent)};
}

Angle tangent_of_bow(Dir<World> view, Dir<World> to_sun) {
    const Vec3 tangent = cross(view.v, to_sun.v);
    const Vec3 up{0.0, 1.0, 0.0};
    const Vec3 vertical = up - dot(up, view.v) * view.v, left = cross(vertical, view.v);
    const double along = dot(tangent, vertical), across = dot(tangent, left);
    if (along == 0.0 && across == 0.0) return {};
    // A direction and its opposite are one.
    return std::atan(across / along) * unit::rad;
}

double through_polariser(const Stokes& light, Angle axis) {
    return 0.5 * (light.i + light.q * cos(2.0 * axis) + light.u * sin(2.0 * axis));
}

double degree_of_polarisation(const Intensities& scattered) {
    const double sum = scattered.perpendicular + scattered.parallel;
    return sum > 0.0 ? (scattered.perpendicular - scattered.parallel) / sum : 0.0;
}

double degree_of_polarisation(const Stokes& light) {
    return light.i > 0.0 ? std::hypot(light.q, light.u) / light.i : 0.0;
}

double perpendicular_share(const Intensities& scattered) {
    const double sum = scattered.perpendicular + scattered.parallel;
    return sum > 0.0 ? scattered.perpendicular / sum : 0.5;
}

}  // namespace dewbow
