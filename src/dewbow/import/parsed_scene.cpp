// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/parsed_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

constexpr Vec3 kMirrorX{-1.0, 1.0, 1.0};

Vec3 mirrored(Vec3 v) { return {-v.x, v.y, v.z}; }

std::shared_ptr<const Mesh> mirrored(const Mesh& mesh) {
    auto result = std::make_shared<Mesh>(mesh);
    for (Point<Object>& vertex : result->vertices) vertex.v = mirrored(vertex.v);
    for (Normal<Object>& normal : result->normals) normal.v = mirrored(normal.v);
    // The bitangent is mirrored too, while normal × tangent turns to the other side.
    for (auto& tangent : result->tangents) tangent[0] = -tangent[0], tangent[3] = -tangent[3];
    for (auto& triangle : result->triangles) std::swap(triangle[1], triangle[2]);
    return result;
}

/// Which materials shapes show, through mixes too.
std::vector<char> materials_in_use(const Scene& scene) {
    std::vector<char> used(scene.materials.size(), 0);
    std::vector<int> open;
    const auto use = [&](int index) {
        if (index < 0 || std::size_t(index) >= used.size() || used[std::size_t(index)]) return;
        used[std::size_t(index)] = 1;
        open.push_back(index);
    };
    for (const Shape& shape : scene.shapes) use(shape.material);
    while (!open.empty()) {
        const Material& material = scene.materials[std::size_t(open.back())];
        open.pop_back();
        if (const auto* mix = std::get_if<Mix>(&material.surface)) {
            use(mix->first);
            use(mix->second);
        }
    }
    return used;
}

/// The largest that the surface may have, in cd m⁻²: of a picture, where its texels are white.
double luminance_of(const Material& material) {
    if (material.emission) return kLuminousEfficacy * xyz_from_spectrum(*material.emission)[1];
    const auto& factor = material.emission_texture->factor;
    return kLuminousEfficacy * cie_y_integral() * xyz_from_rgb(factor)[1];
}

/// Whether a light without extent can be seen by what the surface does to it.
/// Whether it shows light that has no extent: it is rough, or hazy inside.
bool scatters(const Material& material) {
    if (const auto* s = std::get_if<Dielectric>(&material.surface))
        return s->roughness.value > 0.0 || s->interior->scattering;
    if (const auto* s = std::get_if<ThinDielectric>(&material.surface))
        return s->roughness.value > 0.0;
    if (const auto* s = std::get_if<Conductor>(&material.surface)) return s->roughness.value > 0.0;
    return std::holds_alternative<Diffuse>(material.surface) ||
           std::holds_alternative<MetallicRoughness>(material.surface);
}

}  // namespace

void offer_camera(Scene& scene, CameraView camera) {
    if (camera.name.empty()) camera.name = "camera";
    const std::string stem = camera.name;
    const auto taken = [&] {
        return std::any_of(scene.cameras.begin(), scene.cameras.end(),
                           [&](const CameraView& other) { return other.name == camera.name; });
    };
    for (int number = 2; taken(); ++number) camera.name = fmt::format("{} {}", stem, number);
    scene.cameras.push_back(std::move(camera));
}

bool brings_light(const Scene& scene, double least_luminance) {
    const std::vector<char> used = materials_in_use(scene);
    bool something_scatters = scene.surroundings->scattering != nullptr;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Material& material = scene.materials[i];
        if (material.gives_light() && luminance_of(material) > least_luminance) return true;
        something_scatters |= scatters(material);
    }
    // Smooth glass and mirrors alone show nothing of a light that has no extent.
    return std::any_of(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
        const bool extent =
            std::holds_alternative<UniformEnvironment>(light) ||
            std::holds_alternative<std::shared_ptr<const ImageEnvironment>>(light) ||
            std::holds_alternative<SkyDomePtr>(light);
        return extent || something_scatters;
    });
}

Shape Mirrors::upright(Shape shape) {
    const Affine& affine = shape.world_from_object.affine();
    if (affine.determinant() >= 0.0) return shape;
    shape.world_from_object = Transform<World, Object>(affine * scaling(kMirrorX));
    auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
    if (!mesh) return shape;
    std::shared_ptr<const Mesh>& copy = copies_[*mesh];
    if (!copy) copy = mirrored(**mesh);
    *mesh = copy;
    return shape;
}

}  // namespace dewbow
