// SPDX-License-Identifier: Apache-2.0
#pragma once

// The glasses, gems and fluids that are known by name. A glass is a row of
// data/glasses/catalogue.csv or makers.csv, and of extinction.csv where its absorption is known.

#include <span>
#include <string>
#include <string_view>

#include "dewbow/optics/glass.h"

namespace dewbow {

/// The catalogue, in the order of its files.
std::span<const Glass> glass_catalogue();

/// The glass of that name or alias. The maker may be left out where the rest is unique, and case
/// and hyphens do not matter ("N-BK7", "diamond", "nbk7"). What catalogue.csv has comes before what
/// makers.csv has: "F2" is schott/F2, and not hikari/F2 or cdgm/F2. Water has a temperature if one
/// is given: "water@25C", "fluid/water@298.15K"; sea water also a salinity in g/kg:
/// "sea-water@20C,35". Throws InputError: unknown with the nearest names, ambiguous with all of
/// them, or a temperature where there is none.
Glass find_glass(std::string_view name);

/// The glasses of a catalogue's text, whose columns are those of data/glasses/catalogue.csv.
/// @param file  its name, for messages. Throws InputError with the line.
std::vector<Glass> glasses_of_csv(std::string_view text, const std::string& file);
/// The first line of such a text, and the line of a glass.
std::string_view glass_csv_header();
std::string csv_line_of(const Glass& glass);

}  // namespace dewbow
