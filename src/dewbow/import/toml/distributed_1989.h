// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/distributed_1989.h"

namespace dewbow::toml_import {

/// The table [render.distributed_1989], or nullptr where there is none.
void read_distributed_1989(const TomlDocument& document, const TomlValue* value,
                           Distributed1989Settings& settings);

}  // namespace dewbow::toml_import
