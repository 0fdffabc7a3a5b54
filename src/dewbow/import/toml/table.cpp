// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace dewbow::toml_import {
namespace {

using namespace std::string_view_literals;

constexpr std::array kLengthSuffixes = {"_m"sv, "_cm"sv, "_mm"sv};
constexpr std::array kPointSuffixes = {""sv, "_m"sv, "_cm"sv, "_mm"sv};
/// In metres: below a picometre nothing is solid.
constexpr double kSmallestLength = 1e-12;

Length unit_of(std::string_view key) {
    if (key.ends_with("_mm")) return unit::mm;
    if (key.ends_with("_cm")) return unit::cm;
    return unit::m;
}

const TomlValue::Table& entries_of(const TomlDocument& document, const TomlValue& value,
                                   const std::string& title) {
    if (value.table()) return *value.table();
    fail(document, value.place, fmt::format("{} is {}; expected a table", title, describe(value)));
}

}  // namespace

Table::Table(const TomlDocument& document, const TomlValue& value, std::string title)
    : document_(document),
      entries_(entries_of(document, value, title)),
      place_(value.place),
      title_(std::move(title)) {}

const TomlEntry* Table::find_entry(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const TomlEntry& entry) { return entry.key == key; });
    return found == entries_.end() ? nullptr : &*found;
}

const TomlValue* Table::find(std::string_view key) {
    const TomlEntry* entry = find_entry(key);
    return entry ? &entry->value : nullptr;
}

const TomlValue& Table::require(std::string_view key) {
    const TomlValue* value = find(key);
    if (!value) fail_missing({std::string(key)}, fmt::format("needs {}", key));
    return *value;
}

void Table::fail_missing(std::vector<std::string> keys, const std::string& sentence) const {
    for (const TomlEntry& entry : entries_) {
        if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
        const std::string meant = nearest_word(entry.key, keys);
        if (meant.empty()) continue;
        fail(document_, entry.key_place, fmt::format("unknown key \"{}\" in {}", entry.key, title_),
             fmt::format("did you mean \"{}\"?", meant));
    }
    fail_here(sentence);
}

std::optional<double> Table::find_number(std::string_view key, const Range& range) {
    const TomlValue* value = find(key);
    if (!value) return std::nullopt;
    return read_number(document_, *value, key, range);
}

double Table::number(std::string_view key, const Range& range, double otherwise) {
    return find_number(key, range).value_or(otherwise);
}

double Table::require_number(std::string_view key, const Range& range) {
    return read_number(document_, require(key), key, range);
}

std::int64_t Table::integer(std::string_view key, std::int64_t low, std::int64_t high,
                            std::int64_t otherwise) {
    const TomlValue* value = find(key);
    return value ? read_integer(document_, *value, key, low, high) : otherwise;
}

bool Table::boolean(std::string_view key, bool otherwise) {
    const TomlValue* value = find(key);
    return value ? read_boolean(document_, *value, key) : otherwise;
}

std::string Table::text(std::string_view key, std::string_view otherwise) {
    const TomlValue* value = find(key);
    return value ? read_text(document_, *value, key) : std::string(otherwise);
}

const TomlEntry* Table::find_suffixed(std::string_view stem,
                                      std::span<const std::string_view> suffixes) {
    const TomlEntry* found = nullptr;
    for (const std::string_view suffix : suffixes) {
        const TomlEntry* entry = find_entry(fmt::format("{}{}", stem, suffix));
        if (entry && found) {
            fail(document_, entry->key_place,
                 fmt::format("{} and {} say the same thing; keep one", found->key, entry->key));
        }
        if (entry) found = entry;
    }
    return found;
}

std::optional<Length> Table::find_length(std::string_view stem) {
    const TomlEntry* entry = find_suffixed(stem, kLengthSuffixes);
    if (!entry) return std::nullopt;
    const Length unit = unit_of(entry->key);
    const Range range{kSmallestLength / unit.to(unit::m), kHuge / unit.to(unit::m)};
    return read_number(document_, entry->value, entry->key, range) * unit;
}

Length Table::require_length(std::string_view stem) {
    const std::optional<Length> length = find_length(stem);
    if (!length) {
        fail_missing(
            {fmt::format("{}_m", stem), fmt::format("{}_cm", stem), fmt::format("{}_mm", stem)},
            fmt::format("needs {0}_m (or {0}_cm or {0}_mm)", stem));
    }
    return *length;
}

std::optional<Vec3> Table::find_point(std::string_view stem) {
    const TomlEntry* entry = find_suffixed(stem, kPointSuffixes);
    if (!entry) return std::nullopt;
    return read_vec3(document_, entry->value, entry->key) * unit_of(entry->key).to(unit::m);
}

Vec3 Table::require_point(std::string_view stem) {
    const std::optional<Vec3> point = find_point(stem);
    if (!point) {
        fail_missing({std::string(stem)}, fmt::format("needs {} = [x, y, z] in metres", stem));
    }
    return *point;
}

void Table::at_most_one_of(std::initializer_list<std::string_view> keys) {
    std::vector<const TomlEntry*> found;
    for (const std::string_view key : keys) {
        if (const TomlEntry* entry = find_entry(key)) found.push_back(entry);
    }
    if (found.size() < 2) return;
    std::sort(found.begin(), found.end());  // in the order of the file
    fail(document_, found[1]->key_place,
         fmt::format("{} has both {} and {}; keep one", title_, found[0]->key, found[1]->key));
}

void Table::finish() const {
    for (const TomlEntry& entry : entries_) {
        if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
        fail(document_, entry.key_place, fmt::format("unknown key \"{}\" in {}", entry.key, title_),
             hint_for(entry.key, known_));
    }
}

void Table::fail_here(const std::string& sentence, const std::string& hint) const {
    fail(document_, place_, fmt::format("{} {}", title_, sentence), hint);
}

}  // namespace dewbow::toml_import
