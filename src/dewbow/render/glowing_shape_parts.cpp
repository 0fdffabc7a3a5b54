// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/render/glowing_shape.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
/// Axis lengths of a transform's linear part agree to this: rounding of rotations.
constexpr double kUniformScale = 1e-9;
/// A part's mean brightness is looked up at this many places squared, and its picture in this many
/// cells squared, at four places each: a screen of 1920 pixels in cells of 30.
constexpr int kLooks = 4;
constexpr int kCells = 64;

/// The scale of a transform that keeps spheres spheres, or nothing.
std::optional<double> uniform_scale(const Affine& a) {
    const double x = length(a.apply_linear({1, 0, 0}));
    const Vec3 unit_x = a.apply_linear({1, 0, 0}) / x;
    const double y = length(a.apply_linear({0, 1, 0})), z = length(a.apply_linear({0, 0, 1}));
    const bool alike = std::abs(x - y) < kUniformScale * x && std::abs(x - z) < kUniformScale * x;
    const bool square =
        std::abs(dot(unit_x, a.apply_linear({0, 1, 0}))) < kUniformScale * x &&
        std::abs(dot(unit_x, a.apply_linear({0, 0, 1}))) < kUniformScale * x &&
        std::abs(dot(a.apply_linear({0, 1, 0}), a.apply_linear({0, 0, 1}))) < kUniformScale * x * x;
    return alike && square ? std::optional(x) : std::nullopt;
}

/// A flat piece of `area` with one normal, or two opposite ones.
LightBounds flat_bounds(const Glow& glow, const Bounds& box, double area, Vec3 normal) {
    return {box, glow.brightness() * area, {normal, 0.0}, kPi / 2.0, glow.two_sided()};
}

}  // namespace

GlowingShape::GlowingShape(const Scene& scene, int index)
    : shape_(index),
      glow_(scene.materials[std::size_t(scene.shapes[std::size_t(index)].material)]),
      world_from_object_(scene.shapes[std::size_t(index)].world_from_object) {
    const Shape& shape = scene.shapes[std::size_t(index)];
    if (std::holds_alternative<Plane>(shape.geometry))
        throw InputError("shape \"" + shape.name + "\" is a plane without end and gives off light",
                         "use a rectangle");
    if (AnalyticShape::holds(shape.geometry)) analytic_.emplace(shape, 0.0);
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry))
        add_ball(*sphere, bounds_of(shape));
    else if (const auto* disc = std::get_if<Disc>(&shape.geometry))
        add_disc(*disc, bounds_of(shape));
    else
        add_faces(shape.geometry);
    if (glow_.varies())
        for (int part = 0; part < parts(); ++part) look_at_glow(part);
}

void GlowingShape::add_faces(const Geometry& geometry) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&geometry)) {
        mesh_ = *mesh;
        add_faces(*mesh_);
    } else if (const auto* rectangle = std::get_if<Rectangle>(&geometry)) {
        add_faces(*rectangle);
    } else if (const auto* box = std::get_if<Box>(&geometry)) {
        add_faces(*box);
        name_faces(6);
    } else {
        add_faces(std::get<Prism>(geometry));
        name_faces(5);
    }
}

/// Faces of a polyhedron are numbered by AnalyticShape, in its own order.
void GlowingShape::name_faces(int primitives) {
    for (Face& face : std::get<std::vector<Face>>(surface_)) {
        double most = -2.0;
        for (int primitive = 0; primitive < primitives; ++primitive) {
            const double alike = dot(face.normal, analytic_->normal(face.corner, primitive));
            if (alike <= most) continue;
            most = alike;
            face.primitive = primitive;
        }
    }
}

/// What the bounds of a part do not know yet: that it is a picture, or there in part.
void GlowingShape::look_at_glow(int part) {
    LightBounds& bounds = bounds_[std::size_t(part)];
    if (!(bounds.intensity > 0.0)) return;
    bounds.intensity *= mean_brightness(part) / glow_.brightness();
    auto* faces = std::get_if<std::vector<Face>>(&surface_);
    if (!faces || (*faces)[std::size_t(part)].triangle) return;
    pictures_.push_back(picture_of(part));
    (*faces)[std::size_t(part)].picture = int(pictures_.size()) - 1;
}

double GlowingShape::mean_brightness(int part) const {
    double sum = 0.0;
    for (int i = 0; i < kLooks * kLooks; ++i) {
        const std::array<double, 2> u{(i % kLooks + 0.5) / kLooks, (i / kLooks + 0.5) / kLooks};
        const SurfacePoint p = point_of(part, u);
        sum += glow_.brightness(coordinates(p.position, p.primitive, p.u, p.v));
    }
    return sum / (kLooks * kLooks);
}

/// Brightness over a parallelogram; what is brighter is sampled more.
Distribution2D GlowingShape::picture_of(int part) const {
    std::vector<double> weights(kCells * kCells, 0.0);
    for (int y = 0; y < 2 * kCells; ++y)
        for (int x = 0; x < 2 * kCells; ++x) {
            const SurfacePoint p =
                point_at(part, {(x + 0.5) / (2 * kCells), (y + 0.5) / (2 * kCells)});
            weights[std::size_t(y / 2 * kCells + x / 2)] +=
                glow_.brightness(coordinates(p.position, p.primitive, p.u, p.v));
        }
    return Distribution2D(weights, kCells, kCells);
}

/// All in the object's frame; `edge_u` × `edge_v` points outwards.
void GlowingShape::add_face(Vec3 corner, Vec3 edge_u, Vec3 edge_v, bool triangle) {
    const Affine& world = world_from_object_.affine();
    auto& faces = std::get<std::vector<Face>>(surface_);
    Face face;
    face.corner = world.apply(corner);
    face.edge_u = world.apply_linear(edge_u);
    face.edge_v = world.apply_linear(edge_v);
    face.triangle = triangle;
    face.primitive = int(faces.size());
    const Vec3 across = cross(face.edge_u, face.edge_v);
    const double twice = length(across);
    if (twice > 0.0) {
        face.normal = across * ((world.determinant() < 0.0 ? -1.0 : 1.0) / twice);
        face.area = triangle ? 0.5 * twice : twice;
    }
    Bounds box;
    for (const Vec3 p : {face.corner, face.corner + face.edge_u, face.corner + face.edge_v})
        box.add(p);
    if (!triangle) box.add(face.corner + face.edge_u + face.edge_v);
    bounds_.push_back(flat_bounds(glow_, box, face.area, face.normal));
    faces.push_back(face);
}

void GlowingShape::add_faces(const Mesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 corner = mesh.vertices[a].v;
        add_face(corner, mesh.vertices[b].v - corner, mesh.vertices[c].v - corner, true);
    }
}

void GlowingShape::add_faces(const Rectangle& rectangle) {
    const Vec3 x{rectangle.width.to(unit::m), 0.0, 0.0}, y{0.0, rectangle.height.to(unit::m), 0.0};
    add_face(-0.5 * (x + y), x, y, false);
}

void GlowingShape::add_faces(const Box& box) {
    const Vec3 x{box.width.to(unit::m), 0.0, 0.0}, y{0.0, box.height.to(unit::m), 0.0},
        z{0.0, 0.0, box.depth.to(unit::m)};
    const Vec3 low = -0.5 * (x + y + z), high = -low;
    for (const auto& [u, v] : {std::pair{x, y}, {y, z}, {z, x}}) {
        add_face(low, v, u, false);
        add_face(high, -u, -v, false);
    }
}

void GlowingShape::add_faces(const Prism& prism) {
    // The centroid of a triangle lies at a third of its height.
    const double side = prism.side.to(unit::m);
    const double height = side * cos(prism.apex / 2.0), half = side * sin(prism.apex / 2.0);
    const Vec3 apex{0.0, height * 2.0 / 3.0, 0.0}, left{-half, -height / 3.0, 0.0},
        right{half, -height / 3.0, 0.0};
    const Vec3 z{0.0, 0.0, 0.5 * prism.length.to(unit::m)};
    add_face(apex + z, left - apex, right - apex, true);
    add_face(apex - z, right - apex, left - apex, true);
    for (const auto& [a, b] : {std::pair{apex, left}, {left, right}, {right, apex}})
        add_face(a + z, -2.0 * z, b - a, false);
}

void GlowingShape::add_disc(const Disc& disc, const Bounds& box) {
    const Affine& world = world_from_object_.affine();
    const double radius = disc.radius.to(unit::m);
    const Vec3 x = world.apply_linear({radius, 0, 0}), y = world.apply_linear({0, radius, 0});
    const Vec3 normal = world_from_object_(Normal<Object>{{0, 0, 1}}).v;
    const double area = kPi * length(cross(x, y));
    bounds_.push_back(flat_bounds(glow_, box, area, normal));
    surface_ = FlatDisc{normal, radius, area};
}

void GlowingShape::add_ball(const Sphere& sphere, const Bounds& box) {
    const Affine& world = world_from_object_.affine();
    Ball ball{world.apply({}), sphere.radius.to(unit::m), uniform_scale(world)};
    if (ball.radius) *ball.radius *= ball.object_radius;
    // The largest shadow of an ellipsoid is at most that of a sphere of its longest axis; a mean
    // is near enough.
    const double radius = ball.object_radius * std::cbrt(std::abs(world.determinant()));
    bounds_.push_back(
        {box, glow_.brightness() * kPi * radius * radius, DirectionCone::all(), kPi / 2.0, false});
    surface_ = ball;
}

}  // namespace dewbow
