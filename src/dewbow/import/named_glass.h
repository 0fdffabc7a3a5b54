// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "dewbow/optics/catalogue.h"

namespace dewbow {

/// The index that scene files and options mean by `name`: a glass of the catalogue, "air" or
/// "vacuum". Throws InputError with the nearest names.
inline DispersionPtr named_glass(std::string_view name) {
    // The very function that surrounds bodies by default, so that air in air bends nothing.
    if (name == "air" || name == "fluid/air") return air();
    if (name == "vacuum") return vacuum();
    return make_dispersion(find_glass(name).data);
}

}  // namespace dewbow
