// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a glTF material states, with the specification's defaults.

#include <limits>

#include "dewbow/import/gltf/textures.h"
#include "dewbow/scene/material.h"

namespace dewbow::gltf {

/// A factor, times a texture if there is one.
struct ColourProperty {
    Vec3 factor;
    TexturePtr texture{};

    bool is(Vec3 colour) const { return !texture && factor == colour; }
};

struct MaterialProperties {
    std::string name;
    ColourProperty base_colour{{1.0, 1.0, 1.0}};
    NumberInput metallic = 1.0, roughness = 1.0;
    std::optional<Coverage> coverage{};  ///< alphaMode MASK or BLEND
    std::optional<NormalMap> normal_map{};
    ColourProperty emissive{{}};  ///< nits: with KHR_materials_emissive_strength
    bool unlit = false;           ///< shows its base colour, whatever shines on it

    double ior = 1.5;  ///< 0: reflects all [KHR_materials_ior]
    NumberInput transmission = 0.0;
    double thickness = 0.0;                                                 ///< 0: thin-walled
    double attenuation_distance = std::numeric_limits<double>::infinity();  ///< metres
    Vec3 attenuation_colour{1.0, 1.0, 1.0};
    double dispersion = 0.0;  ///< 20 / Abbe number

    NumberInput specular = 1.0;
    ColourProperty specular_colour{{1.0, 1.0, 1.0}};
    NumberInput clearcoat = 0.0, clearcoat_roughness = 0.0;
    ColourProperty sheen_colour{{}};
    NumberInput sheen_roughness = 0.0;

    std::optional<Json> glass;  ///< extras.dewbow.glass or extras.glass
};

/// Reads them, and notes what the material asks for beyond them. Throws InputError.
MaterialProperties read_properties(Document& document, Textures& textures, const Json& material);

}  // namespace dewbow::gltf
