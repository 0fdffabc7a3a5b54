// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/places.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "dewbow/base/file.h"
#include "dewbow/base/parse_number.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kScaleRange{1e-9, 1e9};
constexpr Range kAngleRange_deg{-1e6, 1e6};
constexpr std::string_view kBetween = " \t,;\r";

struct Column {
    const char* name;
    Range range;
};
constexpr std::array<Column, 5> kColumns{{{"x", kCoordinateRange},
                                          {"y", kCoordinateRange},
                                          {"z", kCoordinateRange},
                                          {"rotate_y_deg", kAngleRange_deg},
                                          {"scale", kScaleRange}}};
constexpr std::size_t kLeastColumns = 3;

class PlacesReader {
public:
    PlacesReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    std::vector<Place> read() {
        std::vector<Place> places;
        for (std::size_t begin = 0; begin < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            ++line_;
            read_line(text_.substr(begin, end - begin), places);
            begin = end + 1;
        }
        if (places.empty()) throw InputError(SourcePlace{file_, 0, 0, {}}, "holds no place");
        return places;
    }

private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(text_, line_)),
                         "expected: x, y, z[, rotate_y_deg[, scale]]");
    }

    void read_line(std::string_view line, std::vector<Place>& places) {
        std::array<double, kColumns.size()> v{0.0, 0.0, 0.0, 0.0, 1.0};
        std::size_t count = 0;
        std::size_t begin = line.find_first_not_of(kBetween);
        if (begin == std::string_view::npos || line[begin] == '#') return;
        const bool is_first = !std::exchange(has_begun_, true);
        while (begin != std::string_view::npos) {
            const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
            const std::string_view word = line.substr(begin, end - begin);
            const auto number = parse_number<double>(word);
            if (!number && is_first && count == 0) return;  // the columns' names
            if (!number) fail(fmt::format("\"{}\" is no number", word.substr(0, 40)));
            if (count == kColumns.size()) fail("there are more than five numbers");
            if (!kColumns[count].range.contains(*number))
                fail(fmt::format("{} is {}; it must be {}", kColumns[count].name, *number,
                                 kColumns[count].range.text()));
            v[count++] = *number;
            begin = line.find_first_not_of(kBetween, end);
        }
        if (count < kLeastColumns) fail(fmt::format("there are {} numbers of at least 3", count));
        places.push_back({{v[0], v[1], v[2]}, float(v[3]), float(v[4])});
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t line_ = 0;
    bool has_begun_ = false;
};

std::vector<Place> places_of_array(const TomlDocument& document, const TomlValue& value,
                                   std::string_view key, double unit_m) {
    const TomlValue::Array* array = value.array();
    if (!array || array->empty())
        fail(document, value.place,
             fmt::format("{} is {}; expected [[x, y, z], …]", key, describe(value)));
    std::vector<Place> places;
    places.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i)
        places.push_back(
            {read_vec3(document, (*array)[i], fmt::format("{}[{}]", key, i)) * unit_m});
    return places;
}

}  // namespace

Affine Place::affine() const {
    const double s = double(scale);
    return translation(position) * rotation({0.0, 1.0, 0.0}, double(rotate_y_deg) * unit::deg) *
           scaling({s, s, s});
}

std::vector<Place> read_places(Table& table, const std::filesystem::path& folder) {
    constexpr std::pair<const char*, double> kKeys[] = {
        {"positions", 1.0}, {"positions_m", 1.0}, {"positions_cm", 0.01}, {"positions_mm", 0.001}};
    table.at_most_one_of({"file", "positions", "positions_m", "positions_cm", "positions_mm"});
    for (const auto& [key, unit_m] : kKeys)
        if (const TomlValue* value = table.find(key))
            return places_of_array(table.document(), *value, key, unit_m);
    const TomlValue* file = table.find("file");
    if (!file) return {Place{}};
    const std::string& reference = read_text(table.document(), *file, "file");
    return at_place(table.document(), file->place, [&] {
        const std::filesystem::path path = resolve_inside(folder, reference);
        return parse_places(path.string(), read_file(path));
    });
}

std::vector<Place> parse_places(const std::string& file, std::string_view text) {
    return PlacesReader(file, text).read();
}

}  // namespace dewbow::toml_import
