// SPDX-License-Identifier: Apache-2.0
#pragma once

// chaos = { … }: the solid texture that makes rain and rainbows uneven.

#include "dewbow/import/toml/table.h"
#include "dewbow/sky/chaos.h"

namespace dewbow::toml_import {

/// The texture at key `chaos` of `table`, if there is one.
/// @param size  the key that its coarsest features are stated by: "size_m" of a texture over
/// places, "size_deg" of one over directions.   Throws InputError with its place.
std::optional<Chaos> find_chaos(Table& table, std::string_view size);

}  // namespace dewbow::toml_import
