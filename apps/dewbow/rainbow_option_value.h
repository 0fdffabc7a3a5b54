// SPDX-License-Identifier: Apache-2.0
#pragma once

// The values of `dewbow rainbow`'s options, from text; as option_value.h has those of the others.

#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/import/range.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// "0.3mm", "10um", "10µm", "3e-4m".
Length parse_drop_radius(std::string_view option, std::string_view text);
/// A number in `range`, with or without the unit's name behind it: "20deg", "20".
double parse_in_range(std::string_view option, std::string_view text, const Range& range,
                      std::string_view unit_name = {});
/// "0,60,137.5" in ascending order, or "FROM:TO:STEP"; the unit's name may stand behind it.
std::vector<double> parse_list(std::string_view option, std::string_view text, const Range& range,
                               std::string_view unit_name);
/// "a,b" of several options as a list of words; none may be empty.
std::vector<std::string> parse_words(std::string_view option,
                                     const std::vector<std::string>& texts);
/// Whole numbers from 0 to 7.
Orders parse_orders(std::string_view option, const std::vector<std::string>& texts);
/// "1.333" or "1.33+1e-8i".
ComplexIndex parse_drop_index(std::string_view option, std::string_view text);

}  // namespace dewbow
