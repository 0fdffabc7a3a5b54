// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/caustics.h"

namespace dewbow::toml_import {

void read_caustics(const TomlDocument& document, const TomlValue* value,
                   CausticsSettings& settings) {
    if (!value) return;
    Table table(document, *value, "[render.caustics]");
    settings.light_paths =
        table.number("light_paths", Range{0.0, kMostLightPaths}, settings.light_paths);
    settings.aimed = table.boolean("aimed", settings.aimed);
    table.finish();
}

}  // namespace dewbow::toml_import
