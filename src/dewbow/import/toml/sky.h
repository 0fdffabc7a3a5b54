// SPDX-License-Identifier: Apache-2.0
#pragma once

// [sky]: sun or moon, the light of the sky around it, and the air between things. docs/sky.md is
// its manual.

#include "dewbow/import/toml/toml_value.h"
#include "dewbow/scene/scene.h"

namespace dewbow::toml_import {

/// Adds what [sky] says to `scene`: a dome of sky light and, where it shines, the sun or moon as a
/// distant light.
/// @throws InputError  unknown keys, values outside their range, a sun below the horizon, a date
/// that does not exist, both sun and moon.
void read_sky(const TomlDocument& document, const TomlValue& value, Scene& scene);

}  // namespace dewbow::toml_import
