// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tables of data/ as columns of numbers.

#include <string>
#include <string_view>
#include <vector>

namespace dewbow {

/// Columns of a comma-separated table. Lines that start with '#' and empty lines are skipped, the
/// first line that is left names the columns. The text is one that is compiled in, so a fault in it
/// is a fault of the program: a row of another width or a field that is no number breaks a check.
std::vector<std::vector<double>> columns_of_csv(std::string_view text);
/// The names of those columns.
std::vector<std::string> column_names_of_csv(std::string_view text);
/// The fields of such a table's rows as text, without the line that names the columns, which must
/// be `header`, and each as wide as it: else a check breaks.
std::vector<std::vector<std::string>> rows_of_csv(std::string_view text, std::string_view header);

/// The fields of one line of CSV; within quotes commas are text and "" is a quote. [RFC 4180]
std::vector<std::string> csv_fields(std::string_view line);

/// The numbers of a field that holds several, between spaces. One that is none breaks a check.
std::vector<double> numbers_of_field(std::string_view field);

}  // namespace dewbow
