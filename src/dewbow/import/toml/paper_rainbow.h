// SPDX-License-Identifier: Apache-2.0
#pragma once

// [paper_rainbow]: the rainbow of Musgrave 1989, 4.3.

#include "dewbow/import/toml/toml_value.h"
#include "dewbow/sky/paper_fog.h"

namespace dewbow::toml_import {

/// Nothing where the file has none. Throws InputError with its place.
std::optional<PaperRainbow> read_paper_rainbow(const TomlDocument& document,
                                               const TomlValue* value);

}  // namespace dewbow::toml_import
