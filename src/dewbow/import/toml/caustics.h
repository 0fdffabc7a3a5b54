// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/caustics_settings.h"

namespace dewbow::toml_import {

/// The table [render.caustics], or nullptr where there is none.
void read_caustics(const TomlDocument& document, const TomlValue* value,
                   CausticsSettings& settings);

}  // namespace dewbow::toml_import
