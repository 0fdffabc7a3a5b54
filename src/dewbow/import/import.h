// SPDX-License-Identifier: Apache-2.0
#pragma once

// From files to a scene.

#include <filesystem>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// What the caller wants otherwise than the file.
struct LoadOptions {
    /// Name of the camera that takes the picture; empty: the file's own choice, or else its first.
    std::string camera;
};

struct ImportedScene {
    Scene scene;
    Diagnostics diagnostics;  ///< what the file asks for and the scene does not hold, each once
};

/// Reads `path` by its extension (.toml, .gltf, .glb, .obj, .ply, .stl), completes it (a camera
/// that frames it and a studio's light where the file brings none) and validates it. Throws
/// InputError.
ImportedScene load_scene(const std::filesystem::path& path, const LoadOptions& options = {});

/// The extensions that load_scene reads, for messages and help.
const std::vector<std::string>& scene_extensions();

}  // namespace dewbow
