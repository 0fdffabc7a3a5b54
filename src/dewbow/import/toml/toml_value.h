// SPDX-License-Identifier: Apache-2.0
#pragma once

// A TOML document as a small tree of our own, with the place of every key and value.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dewbow::toml_import {

struct TomlPlace {
    std::size_t line = 0, column = 0;  ///< from 1
    std::size_t setting = 0;           ///< of TomlDocument::settings, from 1, instead; 0 = the file
};

struct TomlEntry;

struct TomlValue {
    using Array = std::vector<TomlValue>;
    using Table = std::vector<TomlEntry>;

    /// monostate: a date or a time, which no key of ours wants.
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Table> value;
    TomlPlace place;

    const Array* array() const { return std::get_if<Array>(&value); }
    const Table* table() const { return std::get_if<Table>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
};

struct TomlEntry {
    std::string key;
    TomlPlace key_place;
    TomlValue value;
};

/// A file and what stands in it. Values refer to nothing in `text`.
struct TomlDocument {
    std::string file;  ///< as the user named it
    std::string text;
    TomlValue root;                       ///< a table
    std::vector<std::string> settings{};  ///< that were put in (settings.h), as they were given
};

/// Throws InputError with line, column and excerpt where `text` is no TOML.
TomlDocument parse_toml(std::string file, std::string text);

/// What `value` is, for "… is a string": "a string (\"x\")", "the number 3", "an array of 2".
std::string describe(const TomlValue& value);

}  // namespace dewbow::toml_import
