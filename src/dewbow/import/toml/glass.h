// SPDX-License-Identifier: Apache-2.0
#pragma once

// What fills a body, as scene files write it: an index by `glass` (a name of the catalogue), by
// `dispersion` (a formula), by `ior` with `abbe`, or by the paper's `eta_red` and `w`; and how it
// absorbs and scatters.

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/medium.h"

namespace dewbow::toml_import {

/// Reads `glass` | `dispersion` | `ior` and `abbe` | `eta_red` and `w`. Exactly one of the four
/// must be there.
/// @param notes  gets what has to be said of a glass (named_glass.h), unless nullptr.
DispersionPtr read_index(Table& table, Diagnostics* notes);

/// read_index; `absorption_per_m` or `absorption_colour` with `absorption_depth_*`;
/// `scattering_per_m` with `anisotropy` = 0.
MediumPtr read_medium(Table& table, const std::string& name, int priority, Diagnostics* notes);

}  // namespace dewbow::toml_import
