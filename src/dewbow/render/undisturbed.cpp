// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/undisturbed.h"

#include <algorithm>

namespace dewbow {

namespace {

/// With more shapes than this every pair would take too long to look at, and the tree is the better
/// answer.
constexpr std::size_t kMostShapes = 2000;
/// Corners times planes that are looked at for one pair of shapes.
constexpr std::size_t kMostTests = 4'000'000;

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

bool mesh_separated(const ConvexSolid& solid, const Shape& shape, const Mesh& mesh) {
    if (solid.facets().size() * mesh.triangles.size() > kMostTests) return false;
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

}  // namespace

std::vector<bool> find_undisturbed(const Scene& scene,
                                   const std::vector<const ConvexSolid*>& solids) {
    std::vector<bool> result(scene.shapes.size(), false);
    if (scene.shapes.size() > kMostShapes) return result;
    std::vector<Bounds> bounds;
    for (const Shape& shape : scene.shapes) bounds.push_back(bounds_of(shape));

    const auto passes_by = [&](std::size_t body, std::size_t other) {
        const Shape& shape = scene.shapes[other];
        if (std::holds_alternative<Plane>(shape.geometry)) return plane_misses(shape, bounds[body]);
        if (!bounds[body].overlaps(bounds[other])) return true;
        const ConvexSolid* solid = solids[body];
        if (!solid) return false;
        if (separated(*solid, corners_of(bounds[other]))) return true;
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
        return mesh && mesh_separated(*solid, shape, **mesh);
    };
    for (std::size_t body = 0; body < scene.shapes.size(); ++body) {
        const Geometry& geometry = scene.shapes[body].geometry;
        if (!solids[body] && !std::holds_alternative<Sphere>(geometry) &&
            !std::holds_alternative<Box>(geometry) && !std::holds_alternative<Prism>(geometry))
            continue;
        result[body] = true;
        for (std::size_t other = 0; other < scene.shapes.size() && result[body]; ++other)
            result[body] = other == body || passes_by(body, other);
    }
    return result;
}

}  // namespace dewbow
