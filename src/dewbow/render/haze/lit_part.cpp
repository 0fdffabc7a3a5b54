// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/lit_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dewbow {

namespace {

constexpr RayInterval kNothing{0.0, 0.0};

/// Distances at which a t² + 2 b t + c changes its sign, ascending; infinite where it does not.
std::array<double, 2> sign_changes(double a, double b, double c) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (a == 0.0) return {b == 0.0 ? kNever : -0.5 * c / b, kNever};
    const double d = b * b - a * c;
    if (!(d > 0.0)) return {kNever, kNever};
    // The root of larger magnitude first, so that nothing cancels.
    const double q = -(b + std::copysign(std::sqrt(d), b));
    const double first = q / a, second = q == 0.0 ? first : c / q;
    return {std::min(first, second), std::max(first, second)};
}

/// The part of [0, length) in which `inside` holds, of a convex region whose surface is met at
/// `crossings` at most.
template <class Inside>
RayInterval part_within(double length, std::array<double, 3> crossings, Inside&& inside) {
    std::sort(crossings.begin(), crossings.end());
    RayInterval part{length, 0.0};
    double begin = 0.0;
    for (std::size_t i = 0; i <= crossings.size() && begin < length; ++i) {
        const double end = i < crossings.size() ? std::clamp(crossings[i], begin, length) : length;
        const double middle = std::isinf(end) ? 2.0 * begin + 1.0 : 0.5 * (begin + end);
        if (begin < end && inside(middle)) part = {std::min(part.begin, begin), end};
        begin = end;
    }
    return part.empty() ? kNothing : part;
}

}  // namespace

RayInterval part_in_cone(Vec3 origin, Vec3 direction, double length, Vec3 apex, Vec3 axis,
                         double cosine) {
    const Vec3 from = origin - apex;
    const double d_axis = dot(direction, axis), from_axis = dot(from, axis);
    const double c2 = cosine * cosine;
    const auto [first, second] =
        sign_changes(d_axis * d_axis - c2, d_axis * from_axis - c2 * dot(direction, from),
                     from_axis * from_axis - c2 * dot(from, from));
    const double plane = d_axis == 0.0 ? length : -from_axis / d_axis;
    return part_within(length, {first, second, plane}, [&](double t) {
        const Vec3 p = from + direction * t;
        return dot(p, axis) >= cosine * dewbow::length(p);
    });
}

RayInterval BoundingBall::part(Vec3 origin, Vec3 direction) const {
    const Vec3 from = origin - centre;
    const auto [first, second] =
        sign_changes(1.0, dot(direction, from), dot(from, from) - radius * radius);
    return common_part({}, std::isinf(first) ? kNothing : RayInterval{first, second});
}

BoundingBall ball_around(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    return bounds.empty() ? BoundingBall{} : BoundingBall{bounds.centre(), bounds.radius()};
}

RayInterval part_in_cylinder(Vec3 origin, Vec3 direction, double length, Vec3 base, Vec3 axis,
                             double radius) {
    const Vec3 from = origin - base;
    const double d_axis = dot(direction, axis), from_axis = dot(from, axis);
    const Vec3 d_aside = direction - axis * d_axis, from_aside = from - axis * from_axis;
    const auto [first, second] = sign_changes(dot(d_aside, d_aside), dot(d_aside, from_aside),
                                              dot(from_aside, from_aside) - radius * radius);
    const double plane = d_axis == 0.0 ? length : -from_axis / d_axis;
    return part_within(length, {first, second, plane}, [&](double t) {
        const Vec3 aside = from_aside + d_aside * t;
        return from_axis + d_axis * t > 0.0 && dot(aside, aside) <= radius * radius;
    });
}

}  // namespace dewbow
