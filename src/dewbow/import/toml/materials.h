// SPDX-License-Identifier: Apache-2.0
#pragma once

// [materials.NAME] tables. Every one may give off light: `emission` and `two_sided_emission`;
// and may be there in part: `alpha`, `alpha_cutoff`, `vertex_alpha`; and have a `normal_map`.
//
//     type = "diffuse"             reflectance
//     type = "mirror"              reflectance = 1
//     type = "glass"               glass | dispersion | ior [abbe], roughness = 0, tint,
//                                  absorption…, scattering…, priority = 0
//     type = "thin-glass"          glass | dispersion | ior [abbe], roughness = 0, tint
//     type = "metal"               metal | n and k, roughness = 0
//     type = "metallic-roughness"  base_colour, metalness = 1, roughness = 1, ior = 1.5,
//                                  specular = 1, specular_colour, clearcoat = 0,
//                                  clearcoat_roughness = 0, sheen_colour, sheen_roughness = 0
//     type = "mix"                 first, second, second_share = 0.5
//     type = "black"
//
// Colours and numbers may be textures (textures.h).

#include <filesystem>
#include <unordered_map>

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/scene.h"

namespace dewbow::toml_import {

/// Names of the scene file's materials, and where they stand in Scene::materials.
class MaterialNames {
public:
    void add(const std::string& name, int index);
    /// The index of the material that `value` names; InputError with the nearest name otherwise.
    int read(const TomlDocument& document, const TomlValue& value, std::string_view key) const;

private:
    std::unordered_map<std::string, int> indices_;
    std::vector<std::string> names_;
};

/// Adds the materials of the table `materials` to `scene`. Pictures lie in `folder`. nullptr adds
/// none.
MaterialNames read_materials(const TomlDocument& document, const TomlValue* materials,
                             const std::filesystem::path& folder, Scene& scene,
                             Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
