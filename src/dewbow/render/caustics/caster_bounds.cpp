// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caster_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/math/sampling.h"

namespace dewbow::caustics {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Axes of a box's face, when `axis` is perpendicular to it.
constexpr int second(int axis) { return (axis + 1) % 3; }
constexpr int third(int axis) { return (axis + 2) % 3; }

double& component(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

std::optional<CasterBounds::Entry> enter_body(const OrientedBox& box, Vec3 direction,
                                              std::array<double, 2> u) {
    const Vec3 d = box.to_local(direction);
    std::array<double, 3> seen;  // what each face shows
    double all = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        all += seen[std::size_t(axis)] = std::abs(d[axis]) * box.face_area(axis);
    if (!(all > 0.0)) return std::nullopt;
    double rest = u[0] * all;
    int axis = 0;
    while (axis < 2 && rest >= seen[std::size_t(axis)]) rest -= seen[std::size_t(axis++)];
    while (!(seen[std::size_t(axis)] > 0.0)) --axis;  // rounding may leave a rest
    const auto place = detail::held_in_square(rest / seen[std::size_t(axis)], u[1]);
    const Vec3 local = point_on_face(box, place, axis, -d[axis]);
    return CasterBounds::Entry{box.centre + box.to_world(local), 1.0 / all};
}

std::optional<SquarePlace> entry_into(const OrientedBox& box, Vec3 origin, Vec3 direction) {
    const Vec3 o = box.to_local(origin - box.centre), d = box.to_local(direction);
    const auto pass = passage(box, o, d);
    if (!pass) return std::nullopt;
    double before = 0.0, all = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double seen = std::abs(d[axis]) * box.face_area(axis);
        if (axis < pass->axis_in) before += seen;
        all += seen;
    }
    const double own = std::abs(d[pass->axis_in]) * box.face_area(pass->axis_in);
    if (!(own > 0.0)) return std::nullopt;
    const auto place = place_on_face(box, o + d * pass->t_in, pass->axis_in);
    return SquarePlace{detail::held_in_square((before + place[0] * own) / all, place[1]),
                       1.0 / all};
}

std::optional<CasterBounds::Entry> enter_body(const Ball& ball, Vec3 direction,
                                              std::array<double, 2> u) {
    if (!(ball.radius > 0.0)) return std::nullopt;
    const DiscPoint p = sample_concentric_disc(u[0], u[1]);
    const Tangents across = tangents_of(direction);
    return CasterBounds::Entry{ball.centre + (across.t * p.x + across.b * p.y) * ball.radius,
                               1.0 / (kPi * ball.radius * ball.radius)};
}

std::optional<SquarePlace> entry_into(const Ball& ball, Vec3 origin, Vec3 direction) {
    const Tangents across = tangents_of(direction);
    const Vec3 from_centre = origin - ball.centre;
    const DiscPoint p{dot(from_centre, across.t) / ball.radius,
                      dot(from_centre, across.b) / ball.radius};
    if (!(p.x * p.x + p.y * p.y <= 1.0)) return std::nullopt;
    return SquarePlace{square_from_concentric_disc(p), 1.0 / (kPi * ball.radius * ball.radius)};
}

/// A hemisphere of directions alike, from a point `reach` above the plane: all of the plane is met.
/// Per m² of the plane at a distance r from below that point: reach / (2π (r² + reach²)^(3/2)).
double plane_density(const EndlessPlane& plane, double r) {
    const double d = std::hypot(r, plane.reach);
    return plane.reach / (2.0 * kPi * d * d * d);
}

std::optional<CasterBounds::Entry> enter_body(const EndlessPlane& plane, Vec3 direction,
                                              std::array<double, 2> u) {
    const double cosine = std::abs(dot(direction, plane.normal));
    const Vec3 below = sample_uniform_cone(1.0, u[0], u[1]).v;
    if (!(cosine > 0.0) || !(below.z > 0.0)) return std::nullopt;
    const Tangents in = tangents_of(plane.normal);
    const double scale = plane.reach / below.z;
    const double r = scale * std::hypot(below.x, below.y);
    return CasterBounds::Entry{plane.point + (in.t * below.x + in.b * below.y) * scale,
                               plane_density(plane, r) / cosine};
}

std::optional<SquarePlace> entry_into(const EndlessPlane& plane, Vec3 origin, Vec3 direction) {
    const double cosine = dot(direction, plane.normal);
    if (cosine == 0.0) return std::nullopt;
    const Vec3 at = origin - direction * (dot(origin - plane.point, plane.normal) / cosine);
    const Tangents in = tangents_of(plane.normal);
    const Vec3 from_point = at - plane.point;
    const Vec3 below{dot(from_point, in.t), dot(from_point, in.b), plane.reach};
    return SquarePlace{square_from_uniform_cone(1.0, {normalised(below)}),
                       plane_density(plane, std::hypot(below.x, below.y)) / std::abs(cosine)};
}

std::optional<CasterBounds::Crossing> cross(const OrientedBox& box, Vec3 origin, Vec3 direction) {
    const auto pass = passage(box, box.to_local(origin - box.centre), box.to_local(direction));
    if (!pass) return std::nullopt;
    return CasterBounds::Crossing{pass->t_in, pass->t_out};
}
std::optional<CasterBounds::Crossing> cross(const Ball& ball, Vec3 origin, Vec3 direction) {
    const Vec3 to_centre = ball.centre - origin;
    const double along = dot(to_centre, direction);
    const Vec3 aside = to_centre - direction * along;
    const double half2 = ball.radius * ball.radius - dot(aside, aside);
    if (half2 < 0.0) return std::nullopt;
    const double half = std::sqrt(half2);
    return CasterBounds::Crossing{along - half, along + half};
}
std::optional<CasterBounds::Crossing> cross(const EndlessPlane& plane, Vec3 origin,
                                            Vec3 direction) {
    const double slope = dot(direction, plane.normal);
    if (slope == 0.0) return std::nullopt;
    const double t = dot(plane.point - origin, plane.normal) / slope;
    return CasterBounds::Crossing{t, t};
}

}  // namespace

std::optional<Passage> passage(const OrientedBox& box, Vec3 origin, Vec3 direction) {
    Passage result{-kInfinity, kInfinity, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const double o = origin[axis], d = direction[axis], half = box.half[axis];
        if (d == 0.0) {
            if (std::abs(o) > half) return std::nullopt;
            continue;
        }
        const double in = (-std::copysign(half, d) - o) / d;
        if (in > result.t_in) result.t_in = in, result.axis_in = axis;
        result.t_out = std::min(result.t_out, (std::copysign(half, d) - o) / d);
    }
    if (result.t_in > result.t_out) return std::nullopt;
    return result;
}

Vec3 point_on_face(const OrientedBox& box, std::array<double, 2> place, int axis, double side) {
    Vec3 local;
    component(local, axis) = std::copysign(box.half[axis], side);
    component(local, second(axis)) = box.half[second(axis)] * (2.0 * place[0] - 1.0);
    component(local, third(axis)) = box.half[third(axis)] * (2.0 * place[1] - 1.0);
    return local;
}

std::array<double, 2> place_on_face(const OrientedBox& box, Vec3 local, int axis) {
    const auto along = [&](int a) {
        const double half = box.half[a];
        return half > 0.0 ? 0.5 * (1.0 + local[a] / half) : 0.5;
    };
    return detail::held_in_square(along(second(axis)), along(third(axis)));
}

std::optional<CasterBounds::Entry> CasterBounds::enter(Vec3 direction,
                                                       std::array<double, 2> u) const {
    return std::visit([&](const auto& body) { return enter_body(body, direction, u); }, body_);
}

std::optional<SquarePlace> CasterBounds::entry_of(Vec3 origin, Vec3 direction) const {
    return std::visit([&](const auto& body) { return entry_into(body, origin, direction); }, body_);
}

std::optional<CasterBounds::Crossing> CasterBounds::crossing(Vec3 origin, Vec3 direction) const {
    return std::visit([&](const auto& body) { return cross(body, origin, direction); }, body_);
}

Bounds CasterBounds::box() const {
    Bounds result;
    if (endless()) return result;
    Vec3 half;
    if (const auto* box = std::get_if<OrientedBox>(&body_)) {
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 reach = box->axes[std::size_t(axis)] * box->half[axis];
            half += Vec3{std::abs(reach.x), std::abs(reach.y), std::abs(reach.z)};
        }
    } else {
        const double radius = std::get<Ball>(body_).radius;
        half = {radius, radius, radius};
    }
    const Vec3 centre = ball().centre;
    result.add(centre - half);
    result.add(centre + half);
    return result;
}

Ball CasterBounds::ball() const {
    if (const auto* box = std::get_if<OrientedBox>(&body_)) return {box->centre, length(box->half)};
    if (const auto* ball = std::get_if<Ball>(&body_)) return *ball;
    return {std::get<EndlessPlane>(body_).point, kInfinity};
}

double CasterBounds::surface() const {
    if (const auto* box = std::get_if<OrientedBox>(&body_))
        return 2.0 * (box->face_area(0) + box->face_area(1) + box->face_area(2));
    if (const auto* ball = std::get_if<Ball>(&body_))
        return 4.0 * kPi * ball->radius * ball->radius;
    return kInfinity;
}

}  // namespace dewbow::caustics
