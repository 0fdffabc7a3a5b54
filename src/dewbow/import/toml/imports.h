// SPDX-License-Identifier: Apache-2.0
#pragma once

// [[imports]] tables: `file` (.gltf, .glb, .obj, .ply, .stl), `name`, `group` (instances.h), where
// it stands (placement.h), and [imports.materials]: its material's name = the name of a material of
// this file.

#include <filesystem>

#include "dewbow/import/parsed_scene.h"
#include "dewbow/import/toml/instances.h"

namespace dewbow::toml_import {

/// What an import brings that the scene file may refer to.
struct Import {
    std::string name;
    std::vector<CameraView> cameras;  ///< "its name/the camera's name"
    double white_luminance = 0.0;
    bool lit = false;
};

struct ImportContext {
    const MaterialNames& names;
    const std::filesystem::path& folder;  ///< where the files lie
    const ParsedScene* first;             ///< what the first import holds; nullptr = read its file
};

/// Adds the imports of the array `imports` to `scene`, or to `groups`. nullptr adds none.
std::vector<Import> read_imports(const TomlDocument& document, const TomlValue* imports,
                                 const ImportContext& context, Scene& scene, Groups& groups,
                                 Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
