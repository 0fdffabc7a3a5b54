// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/extensions.h"

#include <algorithm>

namespace dewbow::gltf {
namespace {

constexpr std::string_view kHonoured[] = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_node_visibility",
    "KHR_texture_transform",
};
constexpr std::string_view kHarmless[] = {
    "EXT_texture_webp",        // each texture that needs it is noted
    "KHR_materials_variants",  // the file's own choice is shown
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_texture_basisu",  // likewise
    "KHR_xmp",
    "KHR_xmp_json_ld",
};

/// Extensions that do nothing while the value of `key` is `neutral` in all components, as it is by
/// default.
struct NeutralValue {
    std::string_view extension, key;
    double neutral;
};
constexpr NeutralValue kNeutral[] = {
    {"KHR_materials_anisotropy", "anisotropyStrength", 0.0},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0.0},
    {"KHR_materials_iridescence", "iridescenceFactor", 0.0},
};

template <class Names>
bool contains(const Names& names, std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool has_value(const Json& extension, std::string_view key, double neutral) {
    const auto value = extension.find(key);
    if (!value) return true;
    constexpr Range kAny{-kHuge, kHuge};
    return value->number(kAny) == neutral;
}

}  // namespace

bool may_be_required(std::string_view name) {
    return contains(kHonoured, name) || contains(kHarmless, name);
}

bool changes_picture(std::string_view name, const Json& extension) {
    if (contains(kHarmless, name)) return false;
    bool listed = false, neutral = true;
    for (const NeutralValue& row : kNeutral) {
        if (row.extension != name) continue;
        listed = true;
        neutral = neutral && has_value(extension, row.key, row.neutral);
    }
    return !listed || !neutral;
}

}  // namespace dewbow::gltf
