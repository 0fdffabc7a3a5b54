// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tables of data/ as columns of numbers.

#include <string_view>
#include <vector>

namespace dewbow {

/// Columns of a comma-separated table. Lines that start with '#' and empty lines are skipped, the
/// first line that is left names the columns. The text is one that is compiled in, so a fault in it
/// is a fault of the program: a row of another width or a field that is no number breaks a check.
std::vector<std::vector<double>> columns_of_csv(std::string_view text);

}  // namespace dewbow
