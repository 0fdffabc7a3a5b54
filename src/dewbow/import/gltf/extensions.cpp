// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/extensions.h"

#include <algorithm>

namespace dewbow::gltf {
namespace {

constexpr std::string_view kHonoured[] = {
    "KHR_lights_punctual", "KHR_materials_dispersion",   "KHR_materials_emissive_strength",
    "KHR_materials_ior",   "KHR_materials_transmission", "KHR_materials_volume",
};
constexpr std::string_view kHarmless[] = {
    "EXT_meshopt_compression",  // the plain data stand beside it unless it is required
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",  // likewise
    "KHR_materials_variants",      // the file's own choice is shown
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
};
constexpr std::string_view kCompressions[] = {
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
};

/// Extensions that do nothing while the value of `key` is `neutral` in all components, as it is by
/// default.
struct NeutralValue {
    std::string_view extension, key;
    double neutral;
};
constexpr NeutralValue kNeutral[] = {
    {"KHR_materials_anisotropy", "anisotropyStrength", 0.0},
    {"KHR_materials_clearcoat", "clearcoatFactor", 0.0},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0.0},
    {"KHR_materials_iridescence", "iridescenceFactor", 0.0},
    {"KHR_materials_sheen", "sheenColorFactor", 0.0},
    {"KHR_materials_specular", "specularFactor", 1.0},
    {"KHR_materials_specular", "specularColorFactor", 1.0},
};

template <class Names>
bool contains(const Names& names, std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool has_value(const Json& extension, std::string_view key, double neutral) {
    const auto value = extension.find(key);
    if (!value) return true;
    constexpr Range kAny{-kHuge, kHuge};
    if (key.ends_with("ColorFactor")) return value->vec3(kAny) == Vec3{neutral, neutral, neutral};
    return value->number(kAny) == neutral;
}

}  // namespace

bool may_be_required(std::string_view name) {
    return contains(kHonoured, name) ||
           (contains(kHarmless, name) && !contains(kCompressions, name));
}

std::string hint_for_required(std::string_view name) {
    if (contains(kCompressions, name) || name == "KHR_mesh_quantization") {
        return "export the file without compression of meshes";
    }
    return {};
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
