// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where a ray meets a surface.

#include "dewbow/base/random.h"
#include "dewbow/render/film.h"
#include "dewbow/render/prepared_scene.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/receiver.h"
#include "dewbow/render/surface_inputs.h"

namespace dewbow {

/// A surface as a ray meets it.
struct Vertex {
    Vec3 position;
    Vec3 wo;         ///< towards where the path came from
    Vec3 geometric;  ///< normals, turned to the side of wo
    Vec3 shading;
    bool front = true;  ///< met from outside
    int shape = -1, primitive = -1;
    SurfaceCoordinates at;  ///< for textures; set where the material has any

    /// Of light from the side of wo, or from both.
    Receiver receiver(bool both_sides) const {
        return both_sides ? Receiver{position} : Receiver{position, shading};
    }
    /// A ray that leaves along `direction`.
    Ray leave(Vec3 direction) const {
        const double side = dot(direction, geometric);
        const bool outward = front ? side > 0.0 : side < 0.0;
        return {position, direction, {shape, primitive, !outward}};
    }
};

Vertex vertex_at(const PreparedScene& prepared, const Ray& ray, const Hit& hit);
/// The same place as a path meets it that comes from `wo`.
Vertex vertex_from(const PreparedScene& prepared, Vec3 position, Vec3 wo, const Hit& hit);

/// Index of the material that a ray meets: of a mix, the part that the random number chooses.
/// @param vertex  that of the number.
int material_at(const PreparedScene& prepared, const Ray& ray, const Hit& hit, const SampleKey& key,
                std::uint32_t vertex);

/// Into the layers of `sample`: what is seen first, and is made of that material.
void see_first(const PreparedScene& prepared, const Vertex& vertex, int material,
               PixelSample& sample);

inline Vec3 reflected(Vec3 wo, Vec3 normal) { return normal * (2.0 * dot(wo, normal)) - wo; }
/// The shading normal, unless it would send a mirror ray below the true surface.
Vec3 mirror_normal(const Vertex& vertex);

/// A texture may leave parts of a rough surface smooth: they have the least roughness there is.
inline bool is_rough(const Dielectric& glass) {
    return glass.roughness.varies() || glass.roughness.value > 0.0;
}

}  // namespace dewbow
