// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys of a shape of type "terrain":
//
//     size_* height_*           needed
//     feature_* = size / 4      roughness = 0.25     seed = 0
//     cells = 256               middle_finer = 1     island = false
//     valley = { azimuth_deg = 0, width_*, depth = 0.9 }
//     colours = [[r, g, b], …]  mottling = 0
//
// `*` is m, cm or mm.

#include "dewbow/import/terrain/terrain.h"
#include "dewbow/import/toml/table.h"

namespace dewbow::toml_import {

/// Throws InputError.
Terrain read_terrain(Table& table);

}  // namespace dewbow::toml_import
