// SPDX-License-Identifier: Apache-2.0
#pragma once

// [materials.NAME] tables. Every one may give off light: `emission` and `two_sided_emission`.
//
//     type = "diffuse"             reflectance
//     type = "mirror"              reflectance = 1
//     type = "glass"               glass | dispersion | ior [abbe], roughness = 0, tint,
//     absorption…, priority = 0 type = "thin-glass"          glass | dispersion | ior [abbe], tint
//     type = "metallic-roughness"  base_colour, metalness = 1, roughness = 1, ior = 1.5
//     type = "mix"                 first, second, second_share = 0.5
//     type = "black"

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

/// Adds the materials of the table `materials` to `scene`. nullptr adds none.
MaterialNames read_materials(const TomlDocument& document, const TomlValue* materials,
                             Scene& scene);

}  // namespace dewbow::toml_import
