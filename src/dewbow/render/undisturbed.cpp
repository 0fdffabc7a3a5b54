// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/undisturbed.h"

#include <algorithm>

#include "dewbow/render/bounds_index.h"

namespace dewbow {

namespace {

/// Corners times planes that are looked at for one pair of shapes, and for all together: seconds.
/// What is left unlooked at is taken for disturbed, and goes through the tree.
constexpr std::size_t kMostTests = 4'000'000, kMostTestsInAll = 1'000'000'000;

std::array<Vec3, 8> corners_of(const Bounds& b) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y,
                      i & 4 ? b.high.z : b.low.z};
    return corners;
}

/// Whether one plane of the solid has all of `points` outside.
template <class Points>
bool separated(const ConvexSolid& solid, const Points& points) {
    return std::any_of(solid.facets().begin(), solid.facets().end(), [&](const FacetPlane& f) {
        return std::all_of(points.begin(), points.end(),
                           [&](Vec3 p) { return dot(f.normal, p) > f.distance; });
    });
}

/// @param tests_left  how many tests may still be made.
bool mesh_separated(const ConvexSolid& solid, const Shape& shape, const Mesh& mesh,
                    std::size_t& tests_left) {
    const std::size_t tests = solid.facets().size() * mesh.triangles.size();
    if (tests > std::min(kMostTests, tests_left)) return false;
    tests_left -= tests;
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = shape.world_from_object(mesh.vertices[triangle[i]]).v;
        return separated(solid, corners);
    });
}

/// Whether an infinite plane passes a box by.
bool plane_misses(const Shape& plane, const Bounds& box) {
    const Affine object_from_world = plane.world_from_object.inverse().affine();
    int above = 0;
    for (const Vec3& corner : corners_of(box)) above += object_from_world.apply(corner).z > 0.0;
    return above == 0 || above == 8;
}

bool is_convex(const Geometry& geometry) {
    return std::holds_alternative<Sphere>(geometry) || std::holds_alternative<Box>(geometry) ||
           std::holds_alternative<Prism>(geometry);
}

}  // namespace

std::vector<bool> find_undisturbed(const Scene& scene,
                                   const std::vector<const ConvexSolid*>& solids) {
    std::vector<bool> result(scene.shapes.size(), false);
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        if (solids[i] || is_convex(scene.shapes[i].geometry)) bodies.push_back(i);
    if (bodies.empty()) return result;
    const BoundsIndex bounds(bounds_of_shapes(scene));
    std::vector<const Shape*> endless;
    for (const Shape& shape : scene.shapes)
        if (std::holds_alternative<Plane>(shape.geometry)) endless.push_back(&shape);
    std::size_t tests_left = kMostTestsInAll;

    /// Of two shapes whose bounds overlap.
    const auto disturbs = [&](std::size_t body, std::size_t other) {
        const ConvexSolid* solid = solids[body];
        if (other == body) return false;
        if (!solid) return true;
        if (separated(*solid, corners_of(bounds[other]))) return false;
        const Shape& shape = scene.shapes[other];
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
        return !mesh || !mesh_separated(*solid, shape, **mesh, tests_left);
    };
    for (const std::size_t body : bodies)
        result[body] =
            std::all_of(endless.begin(), endless.end(),
                        [&](const Shape* plane) { return plane_misses(*plane, bounds[body]); }) &&
            !bounds.any(bounds[body], [&](std::size_t other) { return disturbs(body, other); });
    return result;
}

}  // namespace dewbow
