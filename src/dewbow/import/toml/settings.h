// SPDX-License-Identifier: Apache-2.0
#pragma once

// Values of a scene file that the command line states otherwise: "film.width=400",
// "materials.flint.glass=\"SF66\"", "shapes.2.apex_deg=50", "shapes.ball.radius_m=1". A path is a
// dotted key of TOML; entries of arrays are counted from 1 or found by their `name`, and the number
// behind the last begins a new one. The value is written as in TOML.

#include "dewbow/import/toml/toml_value.h"

namespace dewbow::toml_import {

/// Puts the values into the document; what is wrong with them is found when it is read, as for the
/// file itself. Throws UsageError, which names the setting, where one is not PATH=VALUE or its path
/// leads nowhere.
void apply_settings(TomlDocument& document, const std::vector<std::string>& settings);

}  // namespace dewbow::toml_import
