// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/analytic_shape.h"

#include <algorithm>
#include <cmath>

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

AnalyticShape::AnalyticShape(const Shape& shape, double contact)
    : contact_(contact *
               std::cbrt(std::abs(shape.world_from_object.inverse().affine().determinant()))),
      object_from_world_(shape.world_from_object.inverse().affine()),
      world_from_object_(shape.world_from_object) {
    using unit::m;
    const auto add_face = [this](Vec3 normal, Vec3 point) {
        const Vec3 n = normalised(normal);
        faces_[std::size_t(face_count_++)] = {n, dot(n, point)};
    };
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
        const Vec3 half = 0.5 * Vec3{box->width.to(m), box->height.to(m), box->depth.to(m)};
        for (const double sign : {-1.0, 1.0}) {
            add_face({sign, 0, 0}, {sign * half.x, 0, 0});
            add_face({0, sign, 0}, {0, sign * half.y, 0});
            add_face({0, 0, sign}, {0, 0, sign * half.z});
        }
    } else if (const auto* prism = std::get_if<Prism>(&shape.geometry)) {
        kind_ = Kind::polyhedron;
        const PrismSection s = section_of(*prism);
        const Vec3 z{0, 0, 1};
        add_face(cross(s.left - s.apex, z), s.apex);
        add_face(cross(s.apex - s.right, z), s.apex);
        add_face(cross(s.right - s.left, z), s.left);
        add_face(z, z * (0.5 * prism->length.to(m)));
        add_face(-z, z * (-0.5 * prism->length.to(m)));
    }
}

bool AnalyticShape::intersect(Vec3 origin, Vec3 direction, bool from_here, bool inward,
                              double t_max, double& t, int& primitive) const {
    const Vec3 o = object_from_world_.apply(origin);
    const Vec3 d = object_from_world_.apply_linear(direction);
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
    for (int i = 0; i < face_count_; ++i) {
        const Face& plane = faces_[std::size_t(i)];
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
    if (kind_ == Kind::sphere) n = object_from_world_.apply(world_point) / radius_;
    if (kind_ == Kind::polyhedron) n = faces_[std::size_t(primitive)].normal;
    return world_from_object_(Normal<Object>{n}).v;
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
