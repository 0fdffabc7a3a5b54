// SPDX-License-Identifier: Apache-2.0
#pragma once

// Two numbers in [0, 1) become a point or a direction. Each function maps the square onto its
// domain so that equal areas stay equal (or cosine-weighted), and neighbours stay neighbours as far
// as that is possible: stratified numbers give stratified points. square_from_… are the inverses;
// what rounding puts outside of the square is held at its edge.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/quantity.h"
#include "dewbow/math/vector.h"

namespace dewbow {

namespace detail {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1

/// The direction with 1 - cos(theta) = `v`, exact for tiny theta, at azimuth 2 pi `u`.
template <class Frame>
Dir<Frame> direction_at(double v, double u) {
    const double sine = std::sqrt(v * (2.0 - v));
    const double azimuth = 2.0 * kPi * u;
    return {{sine * std::cos(azimuth), sine * std::sin(azimuth), 1.0 - v}};
}

inline std::array<double, 2> held_in_square(double u0, double u1) {
    return {std::clamp(u0, 0.0, kOneBelow), std::clamp(u1, 0.0, kOneBelow)};
}

/// 1 - cos(theta) over `width`, and azimuth over 2 pi: the inverse of direction_at.
template <class Frame>
std::array<double, 2> square_from_direction(Dir<Frame> d, double width) {
    const double sine2 = d.v.x * d.v.x + d.v.y * d.v.y;
    const double v = d.v.z > 0.0 ? sine2 / (1.0 + d.v.z) : 1.0 - d.v.z;
    const double turn = std::atan2(d.v.y, d.v.x) / (2.0 * kPi);
    return held_in_square(v / width, turn < 0.0 ? turn + 1.0 : turn);
}

}  // namespace detail

/// The direction that stands to `axis` as `d` to the z axis. The turn about the axis is that of
/// tangents_of.
template <class Frame>
Dir<Frame> around(Dir<Frame> axis, Dir<Local> d) {
    const Tangents frame = tangents_of(axis.v);
    return {frame.t * d.v.x + frame.b * d.v.y + axis.v * d.v.z};
}
/// The inverse of around().
template <class Frame>
Dir<Local> from_axis(Dir<Frame> axis, Dir<Frame> d) {
    const Tangents frame = tangents_of(axis.v);
    return {{dot(frame.t, d.v), dot(frame.b, d.v), dot(axis.v, d.v)}};
}

/// All directions alike.
template <class Frame>
Dir<Frame> sample_uniform_sphere(double u0, double u1) {
    return detail::direction_at<Frame>(2.0 * u0, u1);
}
template <class Frame>
std::array<double, 2> square_from_uniform_sphere(Dir<Frame> d) {
    return detail::square_from_direction(d, 2.0);
}
/// Per steradian.
constexpr double pdf_uniform_sphere() { return 1.0 / (4.0 * detail::kPi); }

/// 1 - cos(angle), exact also where cos(angle) rounds to 1: the measure of a cone's width below.
inline double one_minus_cos(Angle angle) {
    const double half = sin(0.5 * angle);
    return 2.0 * half * half;
}

/// Directions alike in the cone about +z whose half angle is alpha.
/// @param width  one_minus_cos(alpha), in (0, 2].   Error: a few ulp of the distance from the axis.
inline Dir<Local> sample_uniform_cone(double width, double u0, double u1) {
    return detail::direction_at<Local>(width * u0, u1);
}
inline std::array<double, 2> square_from_uniform_cone(double width, Dir<Local> d) {
    return detail::square_from_direction(d, width);
}
/// Per steradian, inside the cone.
constexpr double pdf_uniform_cone(double width) { return 1.0 / (2.0 * detail::kPi * width); }

struct DiscPoint {
    double x, y;
};
/// Points alike in the unit disc; squares about the centre become circles.
/// [Shirley & Chiu, "A low distortion map between disk and square", JGT 2(3) 1997]
inline DiscPoint sample_concentric_disc(double u0, double u1) {
    // Not quite -1, so that the radius stays below 1.
    const double a = std::max(2.0 * u0 - 1.0, -detail::kOneBelow);
    const double b = std::max(2.0 * u1 - 1.0, -detail::kOneBelow);
    if (a == 0.0 && b == 0.0) return {0.0, 0.0};
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle =
        wide ? detail::kPi / 4.0 * (b / a) : detail::kPi / 2.0 - detail::kPi / 4.0 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}
inline std::array<double, 2> square_from_concentric_disc(DiscPoint p) {
    const double radius = std::hypot(p.x, p.y);
    if (radius == 0.0) return {0.5, 0.5};
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double along = std::copysign(radius, wide ? p.x : p.y);
    const double aside = along * (4.0 / detail::kPi) * std::atan(wide ? p.y / p.x : p.x / p.y);
    return detail::held_in_square(0.5 * (1.0 + (wide ? along : aside)),
                                  0.5 * (1.0 + (wide ? aside : along)));
}
/// Per unit of area of the unit disc.
constexpr double pdf_concentric_disc() { return 1.0 / detail::kPi; }

/// Directions of the hemisphere about +z, in proportion to their cosine with it, which is always >
/// 0. [Malley's method: the points of a disc, lifted onto the sphere]
inline Dir<Local> sample_cosine_hemisphere(double u0, double u1) {
    const DiscPoint p = sample_concentric_disc(u0, u1);
    // sqrt((1 - r)(1 + r)), r = max(|a|, |b|): the difference of squares would round to 0 at the
    // rim.
    const double r =
        std::min(std::max(std::abs(2.0 * u0 - 1.0), std::abs(2.0 * u1 - 1.0)), detail::kOneBelow);
    return {{p.x, p.y, std::sqrt((1.0 - r) * (1.0 + r))}};
}
/// Of a direction that is not below the horizon.
inline std::array<double, 2> square_from_cosine_hemisphere(Dir<Local> d) {
    return square_from_concentric_disc({d.v.x, d.v.y});
}
/// Per steradian.   @param cosine  of the direction with +z; below the horizon the density is 0.
constexpr double pdf_cosine_hemisphere(double cosine) {
    return cosine > 0.0 ? cosine / detail::kPi : 0.0;
}

/// Weights of a triangle's corners; they sum to 1 and none is negative.
struct Barycentric {
    double a, b, c;
};
/// Points alike in a triangle. The square is folded onto it along its diagonal, without a square
/// root. [Heitz, "A low-distortion map between triangle and square", 2019]
inline Barycentric sample_uniform_triangle(double u0, double u1) {
    const double x = 0.5 * u0, y = 0.5 * u1;
    const double a = u1 > u0 ? x : u0 - y;
    const double b = u1 > u0 ? u1 - x : y;
    return {a, b, 1.0 - std::max(u0, u1)};
}
inline std::array<double, 2> square_from_uniform_triangle(Barycentric p) {
    return p.b > p.a ? detail::held_in_square(2.0 * p.a, p.a + p.b)
                     : detail::held_in_square(p.a + p.b, 2.0 * p.b);
}
/// Per unit of area.
constexpr double pdf_uniform_triangle(double area) { return 1.0 / area; }

}  // namespace dewbow
