// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/lamp_media.h"

namespace dewbow::caustics {

namespace {

bool is_body(const PreparedScene& prepared, int material) {
    if (const auto* mix =
            std::get_if<Mix>(&prepared.scene.materials[std::size_t(material)].surface))
        return is_body(prepared, mix->first) || is_body(prepared, mix->second);
    return prepared.media.interior_of(material) >= 0;
}

std::vector<Bounds> bounds_of_bodies(const PreparedScene& prepared) {
    constexpr double kFar = 1e300;
    std::vector<Bounds> bounds = bounds_of_shapes(prepared.scene);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Shape& shape = prepared.scene.shapes[i];
        if (!is_body(prepared, shape.material))
            bounds[i] = {};
        else if (std::holds_alternative<Plane>(shape.geometry))
            bounds[i] = {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
    }
    return bounds;
}

}  // namespace

LampMedia::LampMedia(const PreparedScene& prepared)
    : prepared_(prepared), bodies_(bounds_of_bodies(prepared)) {}

MediaStack LampMedia::along(const Ray& ray) const {
    if (!bodies_.any({ray.origin, ray.origin}, [](std::size_t) { return true; })) return {};
    // Halfway, so that the lamp's own surface, which may bound a body, is not in question.
    const Hit hit = prepared_.accelerator.intersect(ray);
    if (!hit) return {};
    return media_at(ray.origin + ray.direction * (0.5 * hit.t), prepared_.scene, prepared_.media,
                    prepared_.accelerator);
}

}  // namespace dewbow::caustics
