// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/typed.h"

#include <fmt/format.h>

#include <cmath>

#include "dewbow/import/one_line.h"

namespace dewbow::toml_import {
namespace {

[[noreturn]] void fail_type(const TomlDocument& document, const TomlValue& value,
                            std::string_view name, std::string_view expected) {
    fail(document, value.place,
         fmt::format("{} is {}; expected {}", name, describe(value), expected));
}

std::optional<double> number_of(const TomlValue& value) {
    if (const auto* number = std::get_if<double>(&value.value)) return *number;
    if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return double(*whole);
    return std::nullopt;
}

}  // namespace

void fail(const TomlDocument& document, TomlPlace place, const std::string& sentence,
          const std::string& hint) {
    if (place.setting > 0)
        throw UsageError({one_line("--set " + document.settings[place.setting - 1]), 0, 0, {}},
                         one_line(sentence), {}, one_line(hint));
    throw InputError({document.file, place.line, place.column, {}}, one_line(sentence),
                     std::string(line_of(document.text, place.line)), one_line(hint));
}

double read_number(const TomlDocument& document, const TomlValue& value, std::string_view name,
                   const Range& range) {
    const std::optional<double> number = number_of(value);
    if (!number) fail_type(document, value, name, "a number");
    if (!range.contains(*number)) {
        fail(document, value.place,
             fmt::format("{} is {}; it must be {}", name, *number, range.text()));
    }
    return *number;
}

std::int64_t read_integer(const TomlDocument& document, const TomlValue& value,
                          std::string_view name, std::int64_t low, std::int64_t high) {
    const auto* whole = std::get_if<std::int64_t>(&value.value);
    if (!whole) fail_type(document, value, name, "a whole number");
    if (*whole < low || *whole > high) {
        fail(document, value.place,
             fmt::format("{} is {}; it must be between {} and {}", name, *whole, low, high));
    }
    return *whole;
}

bool read_boolean(const TomlDocument& document, const TomlValue& value, std::string_view name) {
    const auto* boolean = std::get_if<bool>(&value.value);
    if (!boolean) fail_type(document, value, name, "true or false");
    return *boolean;
}

const std::string& read_text(const TomlDocument& document, const TomlValue& value,
                             std::string_view name) {
    if (!value.text()) fail_type(document, value, name, "a string");
    return *value.text();
}

std::size_t read_choice(const TomlDocument& document, const TomlValue& value, std::string_view name,
                        std::span<const std::string> choices) {
    const std::string& word = read_text(document, value, name);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (choices[i] == word) return i;
    }
    fail(document, value.place, fmt::format("unknown {} \"{}\"", name, word),
         hint_for(word, choices));
}

std::vector<double> read_numbers(const TomlDocument& document, const TomlValue& value,
                                 std::string_view name, const Range& range, std::size_t count) {
    const TomlValue::Array* array = value.array();
    const std::string expected =
        count == 0 ? "an array of numbers" : fmt::format("an array of {} numbers", count);
    if (!array || array->empty() || (count != 0 && array->size() != count)) {
        fail_type(document, value, name, expected);
    }
    std::vector<double> numbers;
    numbers.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
        numbers.push_back(
            read_number(document, (*array)[i], fmt::format("{}[{}]", name, i), range));
    }
    return numbers;
}

Vec3 read_vec3(const TomlDocument& document, const TomlValue& value, std::string_view name,
               const Range& range) {
    const std::vector<double> v = read_numbers(document, value, name, range, 3);
    return {v[0], v[1], v[2]};
}

Vec3 read_direction(const TomlDocument& document, const TomlValue& value, std::string_view name) {
    const Vec3 v = read_vec3(document, value, name);
    // Below, the square of the length underflows.
    constexpr double kShortest = 1e-100;
    if (length(v) < kShortest) {
        fail(document, value.place, fmt::format("{} has no direction; it must not be zero", name));
    }
    return normalised(v);
}

}  // namespace dewbow::toml_import
