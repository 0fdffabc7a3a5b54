// SPDX-License-Identifier: Apache-2.0
#pragma once

// Meshes from files that hold one mesh: OBJ and PLY.

#include <filesystem>
#include <memory>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// The extensions that load_mesh reads, with their dot.
const std::vector<std::string>& mesh_extensions();

/// Reads `path` by its extension; the mesh has at least one triangle with area. Throws InputError.
std::shared_ptr<const Mesh> load_mesh(const std::filesystem::path& path, Diagnostics& diagnostics);

/// A scene of that one mesh, in a neutral grey material named "default", without camera and light.
ParsedScene load_mesh_scene(const std::filesystem::path& path);

}  // namespace dewbow
