// SPDX-License-Identifier: Apache-2.0
#pragma once

// [[shapes]] tables: `type`, `material`, `name`, `group` (instances.h), the sizes of the type, and
// where the shape stands (placement.h, with look_at).
//
//     sphere  radius_*                 disc   radius_*               rectangle  width_* height_*
//     box     width_* height_* depth_*        prism  apex_deg side_* length_*
//     plane   (z = 0, without end)            mesh   file            terrain  see terrain.h
//
// `*` is m, cm or mm.

#include <filesystem>

#include "dewbow/import/toml/instances.h"

namespace dewbow::toml_import {

/// Adds the shapes of the array `shapes` to `scene`. Meshes lie in `folder`. nullptr adds none.
/// Shapes with `group` go to `groups`.
void read_shapes(const TomlDocument& document, const TomlValue* shapes, const MaterialNames& names,
                 const std::filesystem::path& folder, Scene& scene, Groups& groups,
                 Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
