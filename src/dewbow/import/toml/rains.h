// SPDX-License-Identifier: Apache-2.0
#pragma once

// [[rain]]: drops in a region. docs/rain.md is the manual.

#include <filesystem>

#include "dewbow/base/error.h"
#include "dewbow/import/toml/toml_value.h"
#include "dewbow/scene/scene.h"

namespace dewbow::toml_import {

/// Rain of an optical depth beyond this, through the region's thinnest way, is an opaque wall, and
/// no doubt a slip of the finger.
inline constexpr double kMostRainDepth = 1000.0;

/// Reads all into `scene.rains`. The lights of the scene must be there already: phase functions are
/// averaged over their discs. Tables of drops are kept in default_cache_directory().
/// Throws InputError with its place.
void read_rains(const TomlDocument& document, const TomlValue* rains,
                const std::filesystem::path& folder, Scene& scene, Diagnostics& diagnostics);

}  // namespace dewbow::toml_import
