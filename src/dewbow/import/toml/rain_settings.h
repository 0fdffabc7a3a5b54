// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/rain_settings.h"

namespace dewbow::toml_import {

/// The table [render.rain], or nullptr where there is none.
void read_rain_settings(const TomlDocument& document, const TomlValue* value,
                        RainSettings& settings);

}  // namespace dewbow::toml_import
