// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/directions_to.h"

#include <algorithm>
#include <cmath>

#include "dewbow/math/sampling.h"

namespace dewbow::caustics {

namespace {

/// Below this solid angle a box's faces are sampled by area, which is quicker and then nearly the
/// same: densities differ by some percent over a face.
constexpr double kSmall_sr = 1e-4;
/// A point nearer to a box than this share of its size is taken to lie in it: what it sees is
/// nearly a hemisphere.
constexpr double kTooNear = 1e-4;

}  // namespace

std::optional<DirectionsTo> DirectionsTo::from(Vec3 point, const CasterBounds& bounds) {
    return std::visit([&](const auto& body) { return to(body, point); }, bounds.body());
}

std::optional<DirectionsTo> DirectionsTo::to(const EndlessPlane&, Vec3) { return std::nullopt; }

std::optional<DirectionsTo> DirectionsTo::to(const Ball& ball, Vec3 point) {
    const Vec3 centre = ball.centre - point;
    const double d2 = dot(centre, centre), sin2 = ball.radius * ball.radius / d2;
    if (!(sin2 < 1.0)) return std::nullopt;
    const double width = sin2 / (1.0 + std::sqrt(1.0 - sin2));
    return DirectionsTo(1.0 / pdf_uniform_cone(width), ToBall{normalised(centre), width});
}

std::optional<DirectionsTo> DirectionsTo::to(const OrientedBox& box, Vec3 point) {
    ToBox to{box, box.to_local(point - box.centre), {}, 0, true};
    const double size = std::max({box.half.x, box.half.y, box.half.z});
    double farthest_out = 0.0, sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double height = std::abs(to.from[axis]) - box.half[axis];
        farthest_out = std::max(farthest_out, height);
        if (!(height > 0.0)) continue;
        Face& face = to.faces[std::size_t(to.count++)];
        face.axis = axis;
        // To its centre: about its solid angle is area × cosine / distance².
        const double d2 = dot(to.from, to.from) - to.from[axis] * to.from[axis] + height * height;
        sum += face.share = box.face_area(axis) * height / (d2 * std::sqrt(d2));
    }
    if (!(farthest_out > kTooNear * size)) return std::nullopt;
    if (sum > kSmall_sr) {
        to.far = false;
        sum = 0.0;
        for (int i = 0; i < to.count; ++i) {
            Face& face = to.faces[std::size_t(i)];
            const int x = (face.axis + 1) % 3, y = (face.axis + 2) % 3;
            face.seen = SphericalRectangle(-box.half[x] - to.from[x], box.half[x] - to.from[x],
                                           -box.half[y] - to.from[y], box.half[y] - to.from[y],
                                           std::abs(to.from[face.axis]) - box.half[face.axis]);
            sum += face.share = face.seen.solid_angle();
        }
    }
    for (int i = 0; i < to.count; ++i) to.faces[std::size_t(i)].share /= sum > 0.0 ? sum : 1.0;
    return DirectionsTo(sum, to);
}

DirectionsTo::Sample DirectionsTo::sample(std::array<double, 2> u) const {
    return std::visit([&](const auto& to) { return sample_of(to, u); }, to_);
}

std::optional<SquarePlace> DirectionsTo::place_of(Vec3 direction) const {
    return std::visit([&](const auto& to) { return place_in(to, direction); }, to_);
}

/// Per sr, the choice of the face included.   @param direction  in the box's axes.
double DirectionsTo::ToBox::density(const Face& face, Vec3 direction, double distance) const {
    if (!far) return face.share / face.seen.solid_angle();
    return face.share * distance * distance /
           (box.face_area(face.axis) * std::abs(direction[face.axis]));
}

DirectionsTo::Sample DirectionsTo::sample_of(const ToBox& to, std::array<double, 2> u) {
    int chosen = 0;
    double rest = u[0];
    while (chosen + 1 < to.count && rest >= to.faces[std::size_t(chosen)].share)
        rest -= to.faces[std::size_t(chosen++)].share;
    while (chosen > 0 && !(to.faces[std::size_t(chosen)].share > 0.0)) --chosen;
    const Face& face = to.faces[std::size_t(chosen)];
    if (!(face.share > 0.0)) return {{0.0, 0.0, 1.0}, 0.0};
    std::array<double, 2> place = detail::held_in_square(rest / face.share, u[1]);
    if (!to.far) {
        const int x = (face.axis + 1) % 3, y = (face.axis + 2) % 3;
        const auto p = face.seen.sample(place);
        const double half_x = to.box.half[x], half_y = to.box.half[y];
        place = {0.5 * (1.0 + (p.x + to.from[x]) / half_x),
                 0.5 * (1.0 + (p.y + to.from[y]) / half_y)};
    }
    const Vec3 way = point_on_face(to.box, place, face.axis, to.from[face.axis]) - to.from;
    const double distance = length(way);
    const Vec3 direction = way / distance;
    return {normalised(to.box.to_world(direction)), to.density(face, direction, distance)};
}

std::optional<SquarePlace> DirectionsTo::place_in(const ToBox& to, Vec3 direction) {
    const Vec3 d = to.box.to_local(direction);
    const auto pass = passage(to.box, to.from, d);
    if (!pass || !(pass->t_in > 0.0)) return std::nullopt;
    double before = 0.0;
    for (int i = 0; i < to.count; before += to.faces[std::size_t(i++)].share) {
        const Face& face = to.faces[std::size_t(i)];
        if (face.axis != pass->axis_in) continue;
        if (!(face.share > 0.0)) return std::nullopt;
        const Vec3 way = d * pass->t_in;
        const int x = (face.axis + 1) % 3, y = (face.axis + 2) % 3;
        const auto place = to.far ? place_on_face(to.box, to.from + way, face.axis)
                                  : face.seen.place_of({way[x], way[y]});
        return SquarePlace{detail::held_in_square(before + face.share * place[0], place[1]),
                           to.density(face, d, pass->t_in)};
    }
    return std::nullopt;
}

DirectionsTo::Sample DirectionsTo::sample_of(const ToBall& to, std::array<double, 2> u) {
    return {around(Dir<World>{to.axis}, sample_uniform_cone(to.width, u[0], u[1])).v,
            pdf_uniform_cone(to.width)};
}

std::optional<SquarePlace> DirectionsTo::place_in(const ToBall& to, Vec3 direction) {
    // |a − b|² / 2 = 1 − cos of the angle between them, without cancellation.
    const Vec3 apart = direction - to.axis;
    if (!(0.5 * dot(apart, apart) <= to.width)) return std::nullopt;
    return SquarePlace{
        square_from_uniform_cone(to.width, from_axis(Dir<World>{to.axis}, Dir<World>{direction})),
        pdf_uniform_cone(to.width)};
}

}  // namespace dewbow::caustics
