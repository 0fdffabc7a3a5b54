// SPDX-License-Identifier: Apache-2.0
#pragma once

// What fills a body, as scene files write it: an index by `glass` (a name of the catalogue), by
// `dispersion` (a formula), by `ior` with `abbe`, or by the paper's `eta_red` and `w`; and how it
// absorbs.

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/medium.h"

namespace dewbow::toml_import {

/// Reads `glass` | `dispersion` | `ior` and `abbe` | `eta_red` and `w`. Exactly one of the four
/// must be there.
/// @param notes  gets what has to be said of a glass (named_glass.h), unless nullptr.
DispersionPtr read_index(Table& table, Diagnostics* notes);

/// read_index, and `absorption_per_m` or `absorption_colour` with `absorption_depth_*`.
MediumPtr read_medium(Table& table, const std::string& name, int priority, Diagnostics* notes);

}  // namespace dewbow::toml_import
