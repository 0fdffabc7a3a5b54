// SPDX-License-Identifier: Apache-2.0
#pragma once

// TOML values as what a key wants: each function returns it or throws InputError that says what was
// found, what was expected and where. `name` is the key as it is to be called in messages.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/import/nested_error.h"
#include "dewbow/import/range.h"
#include "dewbow/import/toml/toml_value.h"
#include "dewbow/math/vector.h"

namespace dewbow::toml_import {

/// InputError; UsageError where a setting of the command line stands there.
[[noreturn]] void fail(const TomlDocument& document, TomlPlace place, const std::string& sentence,
                       const std::string& hint = {});

double read_number(const TomlDocument& document, const TomlValue& value, std::string_view name,
                   const Range& range);
std::int64_t read_integer(const TomlDocument& document, const TomlValue& value,
                          std::string_view name, std::int64_t low, std::int64_t high);
bool read_boolean(const TomlDocument& document, const TomlValue& value, std::string_view name);
const std::string& read_text(const TomlDocument& document, const TomlValue& value,
                             std::string_view name);
/// The index of the word among `choices`.
std::size_t read_choice(const TomlDocument& document, const TomlValue& value, std::string_view name,
                        std::span<const std::string> choices);
/// An array of numbers; `count` of them, or any number from one up if 0.
std::vector<double> read_numbers(const TomlDocument& document, const TomlValue& value,
                                 std::string_view name, const Range& range, std::size_t count = 0);
Vec3 read_vec3(const TomlDocument& document, const TomlValue& value, std::string_view name,
               const Range& range = kCoordinateRange);
/// A vector that is not zero, made unit length.
Vec3 read_direction(const TomlDocument& document, const TomlValue& value, std::string_view name);

/// Calls `make` and gives an InputError of it the place `place`.
template <class Make>
auto at_place(const TomlDocument& document, TomlPlace place, Make make) {
    try {
        return make();
    } catch (const InputError& error) {
        fail(document, place, sentence_with_place(error), error.hint());
    }
}

}  // namespace dewbow::toml_import
