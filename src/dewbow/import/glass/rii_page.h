// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pages of the refractiveindex.info database: one material each, with DATA of the types
// "formula 1" … "formula 9", "tabulated n", "tabulated k" and "tabulated nk".

#include <string>
#include <string_view>

#include "dewbow/import/glass/glass_file.h"

namespace dewbow::glass_import {

/// @param file  the page's name, for places.   @param name  of the glass.
/// Throws InputError with the place if it is no such page, or of no transparent medium.
GlassFile read_rii_page(std::string_view text, const std::string& file, const std::string& name);

}  // namespace dewbow::glass_import
