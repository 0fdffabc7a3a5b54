// SPDX-License-Identifier: Apache-2.0
#pragma once

// [[lights]] tables, by `type`:
//
//     point        position, intensity                         (W/(sr nm))
//     spot         position, direction | look_at, inner_deg = 0, outer_deg, intensity
//     distant      direction (of travel), angular_radius_deg = 0, irradiance     (W/(m² nm))
//     environment  radiance (W/(m² sr nm)), or file (.exr, .hdr) with scale = 1 and rotate_y_deg =
//     0 studio       scale = 1, rotate_y_deg = 0: the soft boxes that scenes without light get

#include <filesystem>

#include "dewbow/base/error.h"
#include "dewbow/import/toml/table.h"
#include "dewbow/scene/scene.h"

namespace dewbow::toml_import {

/// Adds the lights of the array `lights` to `scene`. Pictures lie in `folder`. nullptr adds none.
void read_lights(const TomlDocument& document, const TomlValue* lights,
                 const std::filesystem::path& folder, Scene& scene, Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
