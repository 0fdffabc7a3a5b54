// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where rain falls, in scene files:
//
//     region = "everywhere"
//     region = { type = "layer", bottom_m = 0, top_m = 1200 }
//     region = { type = "box", width_m = 4, height_m = 3, depth_m = 2, position = [0, 1.5, -6] }
//     region = { type = "curtain", from = [-200, 0, -900], to = [600, 0, -700], thickness_m = 150,
//                bottom_m = 0, top_m = 1200 }
//     region = { type = "mesh", file = "cloudburst.ply", position = [0, 0, -300] }
//
// Boxes and meshes are placed as shapes are.

#include <filesystem>

#include "dewbow/import/toml/typed.h"
#include "dewbow/scene/rain.h"

namespace dewbow::toml_import {

/// Files of meshes lie in `folder`. Throws InputError with its place.
std::variant<ConvexRegion, MeshRegion> read_rain_region(const TomlDocument& document,
                                                        const TomlValue& value,
                                                        const std::filesystem::path& folder,
                                                        Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
