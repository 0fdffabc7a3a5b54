// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/glowing_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/sampling.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
/// A point this far outside of a triangle, as a share of its edges, is on it still: rounding of
/// Embree's hits. And what normals of one flat facet may differ by.
constexpr double kEdge = 1e-6;
/// Meshes of more triangles than this are searched by the tree alone, which names the one that is
/// hit. (undisturbed.cpp: convex bodies have at most 256)
constexpr std::size_t kFewFaces = 256;

/// Where a ray from outside along `direction`, within the ball's cone, meets the ball.
double distance_to_ball(Vec3 centre_from_here, double radius, Vec3 direction) {
    const double along = dot(centre_from_here, direction);
    const Vec3 aside = centre_from_here - direction * along;
    return along - std::sqrt(std::max(0.0, radius * radius - dot(aside, aside)));
}

/// 1 − cos of the half angle under which a ball is seen; nothing from inside.
std::optional<double> seen_width(Vec3 centre_from_here, double radius) {
    const double sin2 = radius * radius / dot(centre_from_here, centre_from_here);
    if (!(sin2 < 1.0)) return std::nullopt;
    return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

}  // namespace

std::optional<GlowingShape::Sample> GlowingShape::sample(int part, Vec3 from,
                                                         std::array<double, 2> u) const {
    if (const Ball* ball = std::get_if<Ball>(&surface_); ball && ball->radius) {
        const Vec3 centre = ball->centre - from;
        if (const std::optional<double> width = seen_width(centre, *ball->radius)) {
            const Dir<World> axis{normalised(centre)};
            const Vec3 direction = around(axis, sample_uniform_cone(*width, u[0], u[1])).v;
            const double distance = distance_to_ball(centre, *ball->radius, direction);
            return Sample{from + direction * distance, direction, distance,
                          pdf_uniform_cone(*width)};
        }
    }
    const SurfacePoint p = point_of(part, u);
    const Vec3 to_light = p.position - from;
    const double distance = length(to_light);
    if (!(distance > 0.0)) return std::nullopt;
    const Vec3 direction = to_light / distance;
    const double cosine = -dot(direction, p.normal);
    if (cosine == 0.0 || !shines(direction, p.normal)) return std::nullopt;
    const double pdf = p.pdf_area * distance * distance / std::abs(cosine);
    return Sample{p.position, direction, distance, pdf, p.primitive, p.u, p.v};
}

double GlowingShape::pdf(int part, Vec3 from, Vec3 direction, const Hit& hit) const {
    if (const Ball* ball = std::get_if<Ball>(&surface_); ball && ball->radius)
        if (const auto width = seen_width(ball->centre - from, *ball->radius))
            return pdf_uniform_cone(*width);
    const double cosine = std::abs(dot(direction, hit.normal));
    if (cosine == 0.0) return 0.0;
    return pdf_area(part, from + direction * hit.t) * hit.t * hit.t / cosine;
}

/// A point of a face by its place along the edges, of a disc or a ball by uniform numbers.
GlowingShape::SurfacePoint GlowingShape::point_at(int part, std::array<double, 2> place) const {
    if (const auto* faces = std::get_if<std::vector<Face>>(&surface_)) {
        const Face& face = (*faces)[std::size_t(part)];
        return {face.corner + face.edge_u * place[0] + face.edge_v * place[1],
                face.normal,
                1.0 / face.area,
                face.primitive,
                place[0],
                place[1]};
    }
    if (const auto* disc = std::get_if<FlatDisc>(&surface_)) {
        const DiscPoint p = sample_concentric_disc(place[0], place[1]);
        const Point<Object> local{{disc->radius * p.x, disc->radius * p.y, 0.0}};
        return {world_from_object_(local).v, disc->normal, 1.0 / disc->area};
    }
    const Ball& ball = std::get<Ball>(surface_);
    const Vec3 n = sample_uniform_sphere<Object>(place[0], place[1]).v;
    const Vec3 point = world_from_object_(Point<Object>{n * ball.object_radius}).v;
    return {point, world_from_object_(Normal<Object>{n}).v, pdf_area_of_ball(ball, point)};
}

GlowingShape::SurfacePoint GlowingShape::point_of(int part, std::array<double, 2> u) const {
    const auto* faces = std::get_if<std::vector<Face>>(&surface_);
    if (!faces) return point_at(part, u);
    const Face& face = (*faces)[std::size_t(part)];
    if (face.triangle) {
        const Barycentric b = sample_uniform_triangle(u[0], u[1]);
        return point_at(part, {b.b, b.c});
    }
    if (face.picture < 0) return point_at(part, u);
    const auto place = pictures_[std::size_t(face.picture)].sample(u[0], u[1]);
    SurfacePoint point = point_at(part, {place.x, place.y});
    point.pdf_area *= place.pdf;
    return point;
}

/// Per area of the world at a point of the part.
double GlowingShape::pdf_area(int part, Vec3 point) const {
    if (const auto* disc = std::get_if<FlatDisc>(&surface_)) return 1.0 / disc->area;
    if (const auto* ball = std::get_if<Ball>(&surface_)) return pdf_area_of_ball(*ball, point);
    const Face& face = std::get<std::vector<Face>>(surface_)[std::size_t(part)];
    if (face.picture < 0) return 1.0 / face.area;
    constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1
    const auto place = face.place_of(point);
    return pictures_[std::size_t(face.picture)].pdf(std::clamp(place[0], 0.0, kOneBelow),
                                                    std::clamp(place[1], 0.0, kOneBelow)) /
           face.area;
}

std::array<double, 2> GlowingShape::place_of(int part, Vec3 point) const {
    if (const auto* faces = std::get_if<std::vector<Face>>(&surface_)) {
        const Face& face = (*faces)[std::size_t(part)];
        const auto [x, y] = face.place_of(point);
        if (face.triangle) return square_from_uniform_triangle({1.0 - x - y, x, y});
        const auto place = detail::held_in_square(x, y);
        if (face.picture < 0) return place;
        return pictures_[std::size_t(face.picture)].inverse(place[0], place[1]);
    }
    const Vec3 local = world_from_object_.inverse_affine().apply(point);
    if (const auto* disc = std::get_if<FlatDisc>(&surface_))
        return square_from_concentric_disc({local.x / disc->radius, local.y / disc->radius});
    return square_from_uniform_sphere(Dir<Object>{normalised(local)});
}

Vec3 GlowingShape::normal_at(Vec3 point, int primitive) const {
    if (!mesh_) return analytic_->normal(point, primitive);
    return std::get<std::vector<Face>>(surface_)[std::size_t(primitive)].normal;
}

std::optional<GlowingShape::WorldBall> GlowingShape::ball() const {
    const Ball* ball = std::get_if<Ball>(&surface_);
    if (!ball || !ball->radius) return std::nullopt;
    return WorldBall{ball->centre, *ball->radius};
}

/// An ellipsoid's area element is |det A| |A⁻ᵀ n| times that of its sphere.
double GlowingShape::pdf_area_of_ball(const Ball& ball, Vec3 point) const {
    const Affine& object_from_world = world_from_object_.inverse_affine();
    const Vec3 n = normalised(object_from_world.apply(point));
    const auto& m = object_from_world.m;
    const Vec3 stretched{m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                         m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                         m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
    const double stretch = std::abs(world_from_object_.affine().determinant()) * length(stretched);
    return 1.0 / (4.0 * kPi * ball.object_radius * ball.object_radius * stretch);
}

std::array<double, 2> GlowingShape::Face::place_of(Vec3 point) const {
    // By the vectors in the face that are at right angles to the other edge.
    const Vec3 from_corner = point - corner;
    const Vec3 beside_u = cross(normal, edge_u), beside_v = cross(normal, edge_v);
    return {dot(from_corner, beside_v) / dot(edge_u, beside_v),
            dot(from_corner, beside_u) / dot(edge_v, beside_u)};
}

int GlowingShape::part_of(const Hit& hit, Vec3 point) const {
    const auto* faces = std::get_if<std::vector<Face>>(&surface_);
    if (!faces) return 0;
    if (!mesh_) {
        const auto same = std::find_if(faces->begin(), faces->end(), [&](const Face& face) {
            return face.primitive == hit.primitive;
        });
        return int(same - faces->begin());
    }
    // Rays inside a convex mesh may name another triangle of the same flat facet.
    const auto holds = [&](const Face& face) {
        const auto place = face.place_of(point);
        return std::min({place[0], place[1], 1.0 - place[0] - place[1]}) >= -kEdge &&
               dot(face.normal, hit.normal) > 1.0 - kEdge;
    };
    if (faces->size() > kFewFaces || holds((*faces)[std::size_t(hit.primitive)]))
        return hit.primitive;
    const auto there = std::find_if(faces->begin(), faces->end(), holds);
    return there == faces->end() ? hit.primitive : int(there - faces->begin());
}

SurfaceCoordinates GlowingShape::coordinates(const Sample& sample) const {
    return coordinates(sample.position, sample.primitive, sample.u, sample.v);
}

SurfaceCoordinates GlowingShape::coordinates(Vec3 position, int primitive, double u,
                                             double v) const {
    if (mesh_) return coordinates_on(*mesh_, primitive, u, v);
    const SurfaceChart chart = analytic_->chart(position, primitive);
    return coordinates_on_chart(chart.u, chart.v);
}

}  // namespace dewbow
