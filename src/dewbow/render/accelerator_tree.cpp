// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/accelerator_tree.h"

namespace dewbow {

FacetPlane AcceleratorTree::plane_of(const Instance& instance, int primitive) const {
    const FacetPlane& plane = shared[std::size_t(instance.mesh)].planes[std::size_t(primitive)];
    const Affine& object_from_world =
        described.shapes[std::size_t(instance.shape)].world_from_object.inverse_affine();
    // n · (A x + b) = d  →  (Aᵀ n) · x = d − n · b
    const auto& m = object_from_world.m;
    const Vec3& n = plane.normal;
    const Vec3 world{m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                     m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                     m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
    const double inverse_length = 1.0 / length(world);
    const double distance = plane.distance - dot(n, {m[0][3], m[1][3], m[2][3]});
    return {world * inverse_length, distance * inverse_length};
}

FacetPlane AcceleratorTree::plane_of(int shape, int primitive) const {
    const Place place = places[std::size_t(shape)];
    if (place.kind == Kind::instance)
        return plane_of(instances[std::size_t(place.index)], primitive);
    return meshes[std::size_t(place.index)].planes[std::size_t(primitive)];
}

const ConvexSolid* AcceleratorTree::solid_of(int shape) const {
    const Place place = places[std::size_t(shape)];
    if (place.kind != Kind::world_mesh) return nullptr;
    const WorldMesh& mesh = meshes[std::size_t(place.index)];
    return mesh.solid ? &*mesh.solid : nullptr;
}

const AnalyticShape& AcceleratorTree::analytic_of(int shape) const {
    const Place place = places[std::size_t(shape)];
    return (place.kind == Kind::plane ? planes : analytic)[std::size_t(place.index)];
}

Vec3 AcceleratorTree::centre_of(const Instance& instance) const {
    return described.shapes[std::size_t(instance.shape)].world_from_object.affine().apply(
        shared[std::size_t(instance.mesh)].bounds.centre());
}

bool AcceleratorTree::flat(int shape) const {
    const Place place = places[std::size_t(shape)];
    if (place.kind == Kind::world_mesh) return meshes[std::size_t(place.index)].normals.empty();
    if (place.kind != Kind::instance) return true;
    return shared[std::size_t(instances[std::size_t(place.index)].mesh)].flat;
}

Vec3 AcceleratorTree::vertex_normal(int shape, std::uint32_t vertex) const {
    const Place place = places[std::size_t(shape)];
    if (place.kind == Kind::world_mesh) return meshes[std::size_t(place.index)].normals[vertex];
    return described.shapes[std::size_t(shape)].world_from_object(mesh_of(shape).normals[vertex]).v;
}

}  // namespace dewbow
