// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/analytic_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Cross-section of a prism: apex, lower left, lower right, around the centroid.
struct PrismSection {
    Vec3 apex, left, right;
};
PrismSection section_of(const Prism& prism) {
    const double side = prism.side.to(unit::m);
    const double half = 0.5 * prism.apex.to(unit::rad);
    const double height = side * std::cos(half);
    const double half_base = side * std::sin(half);
    return {{0.0, 2.0 / 3.0 * height, 0.0},
            {-half_base, -height / 3.0, 0.0},
            {half_base, -height / 3.0, 0.0}};
}

}  // namespace

bool AnalyticShape::holds(const Geometry& geometry) {
    return !std::holds_alternative<std::shared_ptr<const Mesh>>(geometry);
}

AnalyticShape::Polyhedron AnalyticShape::box_of(const Box& box) {
    const double x = box.width.to(unit::m), y = box.height.to(unit::m), z = box.depth.to(unit::m);
    Polyhedron result;
    const auto add_face = [&](Vec3 normal, double distance, Vec3 right, Vec3 down) {
        result.faces[std::size_t(result.count++)] = {normal, distance, normal * distance, right,
                                                     down};
    };
    for (const double sign : {-1.0, 1.0}) {
        add_face({sign, 0, 0}, 0.5 * x, {0, 0, -sign * z}, {0, -y, 0});
        add_face({0, sign, 0}, 0.5 * y, {x, 0, 0}, {0, 0, sign * z});
        add_face({0, 0, sign}, 0.5 * z, {sign * x, 0, 0}, {0, -y, 0});
    }
    return result;
}

AnalyticShape::Polyhedron AnalyticShape::prism_of(const Prism& prism) {
    const PrismSection s = section_of(prism);
    const double length = prism.length.to(unit::m);
    Polyhedron result;
    // A side from the edge `top` down to the edge `bottom`, seen from outside.
    // A side from the edge `top` down to the edge `bottom`, seen from outside.
    const auto add_side = [&](Vec3 top, Vec3 bottom, Vec3 right) {
        const Vec3 n = normalised(cross(bottom - top, right));
        result.faces[std::size_t(result.count++)] = {n, dot(n, top), 0.5 * (top + bottom),
                                                     right * length, bottom - top};
    };
    add_side(s.apex, s.left, {0, 0, 1});
    add_side(s.apex, s.right, {0, 0, -1});
    add_side(s.left, s.right, {0, 0, 1});
    const Vec3 middle{0, 0.5 * (s.apex.y + s.left.y), 0};
    for (const double sign : {1.0, -1.0}) {
        const Vec3 n{0, 0, sign};
        result.faces[std::size_t(result.count++)] = {n,
                                                     0.5 * length,
                                                     middle + n * (0.5 * length),
                                                     (s.right - s.left) * sign,
                                                     {0, s.left.y - s.apex.y, 0}};
    }
    return result;
}

AnalyticShape::AnalyticShape(const Shape& shape, double contact)
    : contact_(contact *
               std::cbrt(std::abs(shape.world_from_object.inverse_affine().determinant()))),
      world_from_object_(shape.world_from_object) {
    using unit::m;
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
        kind_ = Kind::sphere;
        radius_ = sphere->radius.to(m);
    } else if (const auto* disc = std::get_if<Disc>(&shape.geometry)) {
        kind_ = Kind::disc;
        radius_ = disc->radius.to(m);
    } else if (const auto* rectangle = std::get_if<Rectangle>(&shape.geometry)) {
        kind_ = Kind::rectangle;
        half_width_ = 0.5 * rectangle->width.to(m);
        half_height_ = 0.5 * rectangle->height.to(m);
    } else if (const auto* box = std::get_if<Box>(&shape.geometry)) {
        kind_ = Kind::polyhedron;
        polyhedron_ = std::make_shared<const Polyhedron>(box_of(*box));
    } else if (const auto* prism = std::get_if<Prism>(&shape.geometry)) {
        kind_ = Kind::polyhedron;
        polyhedron_ = std::make_shared<const Polyhedron>(prism_of(*prism));
    }
}

bool AnalyticShape::intersect(Vec3 origin, Vec3 direction, bool from_here, bool inward,
                              double t_max, double& t, int& primitive) const {
    const Vec3 o = world_from_object_.inverse_affine().apply(origin);
    const Vec3 d = world_from_object_.inverse_affine().apply_linear(direction);
    primitive = 0;
    if (kind_ == Kind::sphere) return intersect_sphere(o, d, from_here, inward, t_max, t);
    if (kind_ == Kind::polyhedron)
        return intersect_polyhedron(o, d, from_here, inward, t_max, t, primitive);
    return intersect_flat(o, d, from_here, t_max, t);
}

bool AnalyticShape::intersect_sphere(Vec3 o, Vec3 d, bool from_here, bool inward, double t_max,
                                     double& t) const {
    const double dd = dot(d, d);
    const double middle = -dot(o, d) / dd;
    if (from_here) {
        // The origin is one root, so the other lies as far behind the middle as the origin before
        // it.
        if (!inward) return false;
        t = std::max(0.0, 2.0 * middle - contact_);
        return t < t_max;
    }
    // The distance of the ray from the centre, without the cancellation of b² − 4ac.
    const Vec3 nearest = o + d * middle;
    const double discriminant = radius_ * radius_ - dot(nearest, nearest);
    if (discriminant < 0.0) return false;
    const double half_chord = std::sqrt(discriminant / dd);
    t = middle - half_chord > 0.0 ? middle - half_chord : middle + half_chord;
    return t > 0.0 && t < t_max;
}

/// Whether a ray goes into a face on which it starts, up to rounding. `height` is the distance from
/// the origin to the plane along its outward normal, `slope` the change of it along the ray.
bool AnalyticShape::enters_at_start(double height, double slope) const {
    return slope < 0.0 && std::abs(height) <= contact_;
}

bool AnalyticShape::intersect_flat(Vec3 o, Vec3 d, bool from_here, double t_max, double& t) const {
    if (from_here || d.z == 0.0) return false;
    t = enters_at_start(o.z, d.z) ? std::max(0.0, -o.z / d.z) : -o.z / d.z;
    if (!((t > 0.0 || enters_at_start(o.z, d.z)) && t < t_max)) return false;
    const double x = o.x + t * d.x, y = o.y + t * d.y;
    if (kind_ == Kind::disc) return x * x + y * y <= radius_ * radius_;
    if (kind_ == Kind::rectangle) return std::abs(x) <= half_width_ && std::abs(y) <= half_height_;
    return true;
}

bool AnalyticShape::intersect_polyhedron(Vec3 o, Vec3 d, bool from_here, bool inward, double t_max,
                                         double& t, int& face) const {
    if (from_here && !inward) return false;
    double t_in = -kInfinity, t_out = kInfinity, height_in = 0.0;
    int face_in = -1, face_out = -1;
    for (int i = 0; i < polyhedron_->count; ++i) {
        const Face& plane = polyhedron_->faces[std::size_t(i)];
        const double slope = dot(plane.normal, d);
        const double height = plane.distance - dot(plane.normal, o);  // > 0 inside
        if (slope == 0.0) {
            if (height < 0.0 && !from_here) return false;
            continue;
        }
        const double at = height / slope;
        if (slope > 0.0 && at < t_out) t_out = at, face_out = i;
        if (slope < 0.0 && at > t_in) t_in = at, face_in = i, height_in = height;
    }
    if (from_here) {
        // Inside by knowledge, whatever rounding says: the ray leaves, if only at once.
        t = std::max(0.0, t_out - contact_);
        face = face_out;
        return t < t_max;
    }
    if (t_in > t_out || t_out <= 0.0) return false;
    const bool enters = t_in > 0.0 || (face_in >= 0 && enters_at_start(height_in, -1.0));
    t = enters ? std::max(0.0, t_in) : t_out;
    face = enters ? face_in : face_out;
    return t < t_max;
}

Vec3 AnalyticShape::normal(Vec3 world_point, int primitive) const {
    Vec3 n{0, 0, 1};
    if (kind_ == Kind::sphere) n = world_from_object_.inverse_affine().apply(world_point) / radius_;
    if (kind_ == Kind::polyhedron) n = polyhedron_->faces[std::size_t(primitive)].normal;
    return world_from_object_(Normal<Object>{n}).v;
}

/// Longitude from −z round by +x, and the angle from +y, of a sphere around the origin.
SurfaceChart AnalyticShape::chart_of_sphere(Vec3 p) const {
    constexpr double kPi = std::numbers::pi;
    const double ring = std::hypot(p.x, p.z);
    const double sine = ring > 0.0 ? p.x / ring : 0.0, cosine = ring > 0.0 ? p.z / ring : 1.0;
    return {0.5 + std::atan2(p.x, p.z) / (2.0 * kPi), std::atan2(ring, p.y) / kPi,
            Vec3{p.z, 0, -p.x} * (2.0 * kPi), Vec3{p.y * sine, -ring, p.y * cosine} * kPi};
}

SurfaceChart AnalyticShape::chart(Vec3 world_point, int primitive) const {
    const Vec3 p = world_from_object_.inverse_affine().apply(world_point);
    const auto flat = [&](Vec3 centre, Vec3 right, Vec3 down) {
        const Vec3 from_centre = p - centre;
        return SurfaceChart{0.5 + dot(from_centre, right) / dot(right, right),
                            0.5 + dot(from_centre, down) / dot(down, down), right, down};
    };
    SurfaceChart result;
    switch (kind_) {
        case Kind::sphere:
            result = chart_of_sphere(p);
            break;
        case Kind::disc:
            result = flat({}, {2.0 * radius_, 0, 0}, {0, -2.0 * radius_, 0});
            break;
        case Kind::rectangle:
            result = flat({}, {2.0 * half_width_, 0, 0}, {0, -2.0 * half_height_, 0});
            break;
        case Kind::polyhedron: {
            const Face& face = polyhedron_->faces[std::size_t(primitive)];
            result = flat(face.centre, face.right, face.down);
            break;
        }
        case Kind::plane:
            result = {p.x, -p.y, {1, 0, 0}, {0, -1, 0}};
            break;
    }
    result.du = world_from_object_.affine().apply_linear(result.du);
    result.dv = world_from_object_.affine().apply_linear(result.dv);
    return result;
}

std::vector<std::array<Vec3, 3>> triangles_of(const Box& box) {
    const Vec3 h = 0.5 * Vec3{box.width.to(unit::m), box.height.to(unit::m), box.depth.to(unit::m)};
    std::vector<std::array<Vec3, 3>> result;
    const auto corner = [&](int axis, double side, double a, double b) {
        const double local[3] = {side, a, b};
        double v[3];
        for (int i = 0; i < 3; ++i) v[(axis + i) % 3] = local[i];
        return Vec3{v[0] * h.x, v[1] * h.y, v[2] * h.z};
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 a = corner(axis, side, -1, -side), b = corner(axis, side, 1, -side);
            const Vec3 c = corner(axis, side, 1, side), d = corner(axis, side, -1, side);
            result.push_back({a, b, c});
            result.push_back({a, c, d});
        }
    }
    return result;
}

std::vector<std::array<Vec3, 3>> triangles_of(const Prism& prism) {
    const PrismSection s = section_of(prism);
    const Vec3 z{0, 0, 0.5 * prism.length.to(unit::m)};
    const std::array<Vec3, 3> ring{s.apex, s.left, s.right};
    std::vector<std::array<Vec3, 3>> result{{s.apex + z, s.left + z, s.right + z},
                                            {s.apex - z, s.right - z, s.left - z}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = ring[i], b = ring[(i + 1) % 3];
        result.push_back({a + z, a - z, b - z});
        result.push_back({a + z, b - z, b + z});
    }
    return result;
}

}  // namespace dewbow
