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

double checked_number(std::string_view field) {
    const auto value = parse_number<double>(field);
    DEWBOW_CHECK(value.has_value(), "a field of an embedded table is a number");
    return *value;
}

/// The next line that is neither empty nor a comment; empty at the end.
std::string_view take_line(std::string_view& rest) {
    while (!rest.empty()) {
        const std::string_view line = without_carriage_return(take_until(rest, '\n'));
        if (!line.empty() && !line.starts_with('#')) return line;
    }
    return {};
}

void append_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    for (std::vector<double>& column : columns) {
        column.push_back(checked_number(take_until(line, ',')));
    }
    DEWBOW_CHECK(line.empty(), "each row of an embedded table is as wide as its first line");
}

}  // namespace

std::vector<std::vector<double>> columns_of_csv(std::string_view text) {
    std::vector<std::vector<double>> columns(count_fields(take_line(text)));
    for (auto line = take_line(text); !line.empty(); line = take_line(text)) {
        append_row(line, columns);
    }
    return columns;
}

std::vector<std::string> column_names_of_csv(std::string_view text) {
    return csv_fields(take_line(text));
}

std::vector<std::vector<std::string>> rows_of_csv(std::string_view text, std::string_view header) {
    DEWBOW_CHECK(take_line(text) == header, "an embedded table has the columns that are read");
    const std::size_t width = csv_fields(header).size();
    std::vector<std::vector<std::string>> rows;
    for (auto line = take_line(text); !line.empty(); line = take_line(text)) {
        rows.push_back(csv_fields(line));
        DEWBOW_CHECK(rows.back().size() == width, "each row of an embedded table is as wide");
    }
    return rows;
}

std::vector<std::string> csv_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += '"';
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

std::vector<double> numbers_of_field(std::string_view field) {
    std::vector<double> values;
    while (!field.empty()) values.push_back(checked_number(take_until(field, ' ')));
    return values;
}

}  // namespace dewbow
