// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion.h"

namespace dewbow {

/// The index that files and options mean by `name`: a glass of the catalogue, "air" or "vacuum".
/// Throws InputError with the nearest names.
/// @param notes  gets what has to be said of the glass (data that end within the visible range, a
/// crystal of which one ray is followed), once however many places name it; nullptr drops it.
DispersionPtr named_glass(std::string_view name, const SourcePlace& place, Diagnostics* notes);

/// The same of a glass file ("maker.agf#N-BK7", "page.yml") that lies in the folder of `place`'s
/// file, with what is wrong with that glass in it.
DispersionPtr glass_of_file(std::string_view reference, const SourcePlace& place,
                            Diagnostics* notes);

}  // namespace dewbow
