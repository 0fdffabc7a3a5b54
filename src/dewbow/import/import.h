// SPDX-License-Identifier: Apache-2.0
#pragma once

// From files to a scene.

#include <filesystem>
#include <optional>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// A material, by name, that is to be a body of a glass.
struct GlassOverride {
    std::string material, glass;
};

/// What the caller wants otherwise than the file.
struct LoadOptions {
    /// Name of the camera that takes the picture; empty: the file's own choice, or else its first.
    std::string camera{};
    /// Of the picture, in pixels; 0 = as the file says. A scene without a camera is framed for it.
    int width = 0, height = 0;
    /// The frame of a glTF file's animations that is shown; none: at rest.
    std::optional<double> frame{};
    double frames_per_second = 24.0;
    /// "film.width=400": values of the scene file, in its words (docs/scene-format.md). A file of
    /// another format is taken as if a scene file imported it.
    std::vector<std::string> settings{};
    std::vector<GlassOverride> glasses{};
    std::string environment{};  ///< a picture that takes the place of all environments; or empty
};

struct ImportedScene {
    Scene scene;
    Diagnostics diagnostics;  ///< what the file asks for and the scene does not hold, each once
};

/// Reads `path` by its extension (.toml, .gltf, .glb, .obj, .ply, .stl), completes it (a camera
/// that frames it and a studio's light where the file brings none) and validates it. Throws
/// InputError, or UsageError where an option is wrong.
ImportedScene load_scene(const std::filesystem::path& path, const LoadOptions& options = {});

/// The extensions that load_scene reads, for messages and help.
const std::vector<std::string>& scene_extensions();

}  // namespace dewbow
