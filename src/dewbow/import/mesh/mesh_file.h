// SPDX-License-Identifier: Apache-2.0
#pragma once

// Meshes from files: OBJ, PLY and STL.

#include <filesystem>
#include <memory>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// The extensions that load_mesh reads, with their dot.
const std::vector<std::string>& mesh_extensions();

/// Reads `path` by its extension as one mesh, whatever objects and materials an OBJ file has; it
/// has at least one triangle with area. Throws InputError.
std::shared_ptr<const Mesh> load_mesh(const std::filesystem::path& path, Diagnostics& diagnostics);

/// A scene of the shapes and materials of an OBJ file (obj_scene.h), or of the one mesh of others
/// in a material named "default" (grey, or the mesh's own colours); without camera and light.
ParsedScene load_mesh_scene(const std::filesystem::path& path);

}  // namespace dewbow
