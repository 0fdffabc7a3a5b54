// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/lamp.h"

#include <algorithm>

#include "dewbow/base/check.h"
#include "dewbow/base/named.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/spectrum/as_bright_as_one.h"
#include "dewbow/spectrum/csv_table.h"
#include "dewbow/spectrum/embedded_data.h"

namespace dewbow {
namespace {

constexpr std::string_view kHeader = "name,kind,description,form,data,width_nm,source,licence";
enum Column { kName, kKind, kDescription, kForm, kData, kWidth, kSource, kLicence };

std::string_view embedded_table(std::string_view name) {
    const auto files = spectrum::data::embedded_files();
    const auto file = std::find_if(files.begin(), files.end(),
                                   [&](const auto& each) { return each.name == name; });
    DEWBOW_CHECK(file != files.end(), "a lamp's table is embedded");
    return file->text;
}

/// Column `column` of the table `name`.csv, whose first column is the wavelength.
SpectrumPtr spectrum_of_table(const std::string& name, const std::string& column) {
    const std::string_view text = embedded_table(name + ".csv");
    const std::vector<std::string> names = column_names_of_csv(text);
    const auto found = std::find(names.begin(), names.end(), column);
    DEWBOW_CHECK(found != names.end(), "a lamp's column is in its table");
    auto columns = columns_of_csv(text);
    return tabulated_as_bright_as_one(columns.front(),
                                      std::move(columns[std::size_t(found - names.begin())]));
}

/// `text` is "wavelength_nm:strength wavelength_nm:strength…".
SpectrumPtr spectrum_of_lines(std::string text, const std::string& width_nm) {
    std::replace(text.begin(), text.end(), ':', ' ');
    const std::vector<double> numbers = numbers_of_field(text);
    const auto width = parse_number<double>(width_nm);
    DEWBOW_CHECK(numbers.size() % 2 == 0 && width, "lines have strengths and a width");
    std::vector<Line> lines;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        lines.push_back({numbers[i] * unit::nm, numbers[i + 1]});
    }
    return lines_as_bright_as_one(std::move(lines), *width * unit::nm);
}

SpectrumPtr spectrum_of_row(const std::vector<std::string>& row) {
    if (row[kForm] == "constant") return make_constant(1.0);
    if (row[kForm] == "lines") return spectrum_of_lines(row[kData], row[kWidth]);
    return spectrum_of_table(row[kForm], row[kData]);
}

std::vector<Lamp> load_lamps() {
    std::vector<Lamp> lamps;
    for (const auto& row : rows_of_csv(spectrum::data::lamps_csv(), kHeader)) {
        lamps.push_back({row[kName], row[kKind], row[kDescription], row[kSource], row[kLicence],
                         spectrum_of_row(row)});
    }
    return lamps;
}

}  // namespace

std::span<const Lamp> lamp_catalogue() {
    static const std::vector<Lamp> kLamps = load_lamps();
    return kLamps;
}

const Lamp& find_lamp(std::string_view name) {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Lamp& lamp : lamp_catalogue()) names.push_back(lamp.name);
        return names;
    }();
    return lamp_catalogue()[find_named("lamp", name, kNames)];
}

}  // namespace dewbow
