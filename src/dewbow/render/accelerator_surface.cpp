// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/render/accelerator.h"
#include "dewbow/render/accelerator_tree.h"

namespace dewbow {

namespace {

/// A triangle of a mesh in its own frame, and a point on it.
struct OnTriangle {
    int triangle = 0;
    double u = 0.0, v = 0.0;  ///< weights of vertices 1 and 2
    Vec3 edge1, edge2;        ///< from vertex 0

    /// How far inside the triangle: the least of the three weights.
    double inside() const { return std::min({u, v, 1.0 - u - v}); }
};

OnTriangle locate(const Mesh& mesh, int triangle, Vec3 point) {
    const auto& [a, b, c] = mesh.triangles[std::size_t(triangle)];
    OnTriangle at;
    at.triangle = triangle;
    at.edge1 = mesh.vertices[b].v - mesh.vertices[a].v;
    at.edge2 = mesh.vertices[c].v - mesh.vertices[a].v;
    const Vec3 n = cross(at.edge1, at.edge2), from_a = point - mesh.vertices[a].v;
    const double squared = dot(n, n);
    if (!(squared > 0.0)) return at;
    at.u = dot(cross(from_a, at.edge2), n) / squared;
    at.v = dot(cross(at.edge1, from_a), n) / squared;
    return at;
}

/// The triangle that the point is on. Hits from within a convex solid name any of their facet.
OnTriangle locate(const Mesh& mesh, const ConvexSolid* solid, int triangle, Vec3 point) {
    OnTriangle best = locate(mesh, triangle, point);
    if (!solid || best.inside() >= 0.0) return best;
    for (const int other : solid->facet_triangles(triangle)) {
        const OnTriangle at = locate(mesh, other, point);
        if (at.inside() > best.inside()) best = at;
    }
    return best;
}
OnTriangle locate(const AcceleratorTree& tree, const Hit& hit, Vec3 world_point) {
    const Shape& shape = tree.described.shapes[std::size_t(hit.shape)];
    return locate(tree.mesh_of(hit.shape), tree.solid_of(hit.shape), hit.primitive,
                  shape.world_from_object.inverse_affine().apply(world_point));
}

/// The file's tangent, for flat and for smooth triangles.  [glTF 2.0, §3.7.2.1]
PictureAxes file_tangents(const Mesh& mesh, const OnTriangle& at) {
    const auto& corners = mesh.triangles[std::size_t(at.triangle)];
    const std::array<double, 3> weight{1.0 - at.u - at.v, at.u, at.v};
    Vec3 right, normal;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& t = mesh.tangents[corners[i]];
        right += Vec3{double(t[0]), double(t[1]), double(t[2])} * weight[i];
        if (!mesh.normals.empty()) normal += normalised(mesh.normals[corners[i]].v) * weight[i];
    }
    if (mesh.normals.empty()) normal = cross(at.edge1, at.edge2);
    const double size = length(normal);
    if (!(size > 0.0)) return {};
    return {right, cross(normal, right) * (double(mesh.tangents[corners[0]][3]) / size)};
}

/// The derivatives of the point by its coordinates; v grows downwards.
PictureAxes derivatives(const Mesh& mesh, const OnTriangle& at, int set) {
    const auto& texcoords =
        mesh.texcoords[std::size_t(mesh.texcoords[std::size_t(set)].empty() ? 1 - set : set)];
    if (texcoords.empty()) return {};
    const auto& [a, b, c] = mesh.triangles[std::size_t(at.triangle)];
    const auto apart = [&](std::uint32_t corner, std::size_t axis) {
        return double(texcoords[corner][axis]) - double(texcoords[a][axis]);
    };
    const double u1 = apart(b, 0), v1 = apart(b, 1), u2 = apart(c, 0), v2 = apart(c, 1);
    const double determinant = u1 * v2 - u2 * v1;
    if (determinant == 0.0) return {};
    return {(at.edge1 * v2 - at.edge2 * v1) / determinant,
            (at.edge1 * u2 - at.edge2 * u1) / determinant};
}

}  // namespace

SurfaceCoordinates Accelerator::coordinates(const Hit& hit, Vec3 point) const {
    if (tree_->is_mesh(hit.shape)) {
        const OnTriangle at = locate(*tree_, hit, point);
        return coordinates_on(tree_->mesh_of(hit.shape), at.triangle, at.u, at.v);
    }
    const SurfaceChart chart = tree_->analytic_of(hit.shape).chart(point, hit.primitive);
    return coordinates_on_chart(chart.u, chart.v);
}

PictureAxes Accelerator::picture_axes(const Hit& hit, Vec3 point, int texcoord_set) const {
    if (!tree_->is_mesh(hit.shape)) {
        const SurfaceChart chart = tree_->analytic_of(hit.shape).chart(point, hit.primitive);
        return {chart.du, -chart.dv};
    }
    const OnTriangle at = locate(*tree_, hit, point);
    const Mesh& mesh = tree_->mesh_of(hit.shape);
    const PictureAxes object =
        mesh.tangents.empty() ? derivatives(mesh, at, texcoord_set) : file_tangents(mesh, at);
    const Affine& world_from_object =
        tree_->described.shapes[std::size_t(hit.shape)].world_from_object.affine();
    return {world_from_object.apply_linear(object.right),
            world_from_object.apply_linear(object.up)};
}

Vec3 Accelerator::shading_normal(const Hit& hit) const {
    if (flat(hit.shape)) return hit.normal;
    const auto& [a, b, c] = tree_->mesh_of(hit.shape).triangles[std::size_t(hit.primitive)];
    const Vec3 n = tree_->vertex_normal(hit.shape, a) * (1.0 - hit.u - hit.v) +
                   tree_->vertex_normal(hit.shape, b) * hit.u +
                   tree_->vertex_normal(hit.shape, c) * hit.v;
    const double squared = dot(n, n);
    if (!(squared > 0.0) || dot(n, hit.normal) <= 0.0) return hit.normal;
    return n / std::sqrt(squared);
}

bool Accelerator::flat(int shape) const { return tree_->flat(shape); }

}  // namespace dewbow
