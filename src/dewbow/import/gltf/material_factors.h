// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of a glTF material, as it states them, with the specification's defaults.

#include <limits>

#include "dewbow/import/gltf/document.h"

namespace dewbow::gltf {

struct MaterialFactors {
    std::string name;
    Vec3 base_colour{1.0, 1.0, 1.0};
    double metallic = 1.0, roughness = 1.0;
    Vec3 emissive;  ///< nits: with KHR_materials_emissive_strength, 0 if a texture would shape it
    double ior = 1.5;  ///< 0: reflects all [KHR_materials_ior]
    double transmission = 0.0;
    double thickness = 0.0;                                                 ///< 0: thin-walled
    double attenuation_distance = std::numeric_limits<double>::infinity();  ///< metres
    Vec3 attenuation_colour{1.0, 1.0, 1.0};
    double dispersion = 0.0;    ///< 20 / Abbe number
    std::optional<Json> glass;  ///< extras.dewbow.glass
};

/// Reads them, and notes what the material asks for beyond them. Throws InputError.
MaterialFactors read_factors(Document& document, const Json& material);

}  // namespace dewbow::gltf
