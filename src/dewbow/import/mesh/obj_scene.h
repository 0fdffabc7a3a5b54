// SPDX-License-Identifier: Apache-2.0
#pragma once

// OBJ files with their materials, as scenes.

#include <filesystem>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// Name of the grey material of faces that say nothing of theirs.
inline constexpr const char* kDefaultMaterial = "default";

/// A neutral grey, or the colours of the mesh.
Material default_material(bool vertex_colours);

/// A shape for each object (where there is none: group) in each material, with the materials of the
/// libraries that the file names. A library that is missing or a material that none holds is
/// noted, and grey takes its place. Throws InputError.
ParsedScene load_obj_scene(const std::filesystem::path& path);

}  // namespace dewbow
