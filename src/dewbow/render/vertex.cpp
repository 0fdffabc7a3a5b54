// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/vertex.h"

#include <algorithm>

#include "dewbow/render/albedo.h"

namespace dewbow {

namespace {

/// The outward shading normal `n`, tilted as the map's texel says.   [glTF 2.0, normalTexture]
Vec3 tilted_normal(const Accelerator& accelerator, const NormalMap& map,
                   const SurfaceCoordinates& at, const Hit& hit, Vec3 position, Vec3 n) {
    const int set = map.texture->texcoord_set;
    const PictureAxes axes = accelerator.picture_axes(hit, position, set);
    const Vec3 right = axes.right - n * dot(axes.right, n);
    const Vec3 up = cross(n, right) * (dot(cross(n, right), axes.up) < 0.0 ? -1.0 : 1.0);
    if (!(dot(right, right) > 0.0)) return n;
    const auto texel = map.texture->eval(at.uv[std::size_t(set)]);
    const double x = map.scale * (2.0 * texel[0] - 1.0), y = map.scale * (2.0 * texel[1] - 1.0);
    const Vec3 tilted =
        normalised(right) * x + normalised(up) * y + n * std::max(0.0, 2.0 * texel[2] - 1.0);
    return dot(tilted, tilted) > 0.0 ? normalised(tilted) : n;
}

}  // namespace

Vec3 mirror_normal(const Vertex& vertex) {
    return dot(reflected(vertex.wo, vertex.shading), vertex.geometric) > 0.0 ? vertex.shading
                                                                             : vertex.geometric;
}

Vertex vertex_at(const PreparedScene& prepared, const Ray& ray, const Hit& hit) {
    return vertex_from(prepared, ray.origin + ray.direction * hit.t, -ray.direction, hit);
}

Vertex vertex_from(const PreparedScene& prepared, Vec3 position, Vec3 wo, const Hit& hit) {
    Vertex v;
    v.position = position;
    v.wo = wo;
    v.front = dot(wo, hit.normal) > 0.0;
    const double side = v.front ? 1.0 : -1.0;
    v.geometric = hit.normal * side;
    v.shading = prepared.accelerator.shading_normal(hit) * side;
    if (dot(v.shading, v.wo) <= 0.0) v.shading = v.geometric;
    v.shape = hit.shape;
    v.primitive = hit.primitive;
    const int id = prepared.scene.shapes[std::size_t(hit.shape)].material;
    const auto& normal_map = prepared.scene.materials[std::size_t(id)].normal_map;
    if (normal_map || prepared.varies[std::size_t(id)])
        v.at = prepared.accelerator.coordinates(hit, v.position);
    if (normal_map) {
        const Vec3 tilted = side * tilted_normal(prepared.accelerator, *normal_map, v.at, hit,
                                                 v.position, v.shading * side);
        if (dot(tilted, v.wo) > 0.0) v.shading = tilted;
    }
    return v;
}

int material_at(const PreparedScene& prepared, const Ray& ray, const Hit& hit, const SampleKey& key,
                std::uint32_t vertex) {
    int id = prepared.scene.shapes[std::size_t(hit.shape)].material;
    while (const auto* mix = std::get_if<Mix>(&prepared.scene.materials[std::size_t(id)].surface)) {
        const double share = mix->second_share.varies()
                                 ? number_at(mix->second_share, vertex_at(prepared, ray, hit).at)
                                 : mix->second_share.value;
        id = key.two(vertex, Purpose::bsdf_lobe)[1] < share ? mix->second : mix->first;
    }
    return id;
}

void see_first(const PreparedScene& prepared, const Vertex& vertex, int material,
               PixelSample& sample) {
    sample.hit = true;
    sample.normal = dot(vertex.shading, vertex.wo) >= 0.0 ? vertex.shading : -vertex.shading;
    sample.depth = prepared.camera.depth_of(vertex.position);
    sample.albedo = albedo_at(prepared.scene.materials[std::size_t(material)],
                              prepared.albedo[std::size_t(material)], vertex.at);
}

}  // namespace dewbow
