// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/csv_table.h"

#include "dewbow/base/check.h"
#include "dewbow/base/parse_number.h"

namespace dewbow {
namespace {

/// Takes what stands before `separator` off the front of `rest`, and the separator with it.
std::string_view take_until(std::string_view& rest, char separator) {
    const std::size_t end = rest.find(separator);
    const std::string_view taken = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return taken;
}

std::string_view without_carriage_return(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::size_t count_fields(std::string_view line) {
    std::size_t count = 0;
    for (; !line.empty(); ++count) take_until(line, ',');
    return count;
}

void append_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    for (std::vector<double>& column : columns) {
        const auto value = parse_number<double>(take_until(line, ','));
        DEWBOW_CHECK(value.has_value(), "a field of an embedded table is a number");
        column.push_back(*value);
    }
    DEWBOW_CHECK(line.empty(), "each row of an embedded table is as wide as its first line");
}

}  // namespace

std::vector<std::vector<double>> columns_of_csv(std::string_view text) {
    std::vector<std::vector<double>> columns;
    while (!text.empty()) {
        const std::string_view line = without_carriage_return(take_until(text, '\n'));
        if (line.empty() || line.starts_with('#')) continue;
        if (columns.empty()) {
            columns.resize(count_fields(line));
        } else {
            append_row(line, columns);
        }
    }
    return columns;
}

}  // namespace dewbow
