// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/toml_value.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "dewbow/base/error.h"

namespace dewbow::toml_import {
namespace {

TomlPlace place_of(const toml::source_region& region) {
    return {region.begin.line, region.begin.column};
}

// The parser itself refuses nesting deeper than 256 values, so this recursion is bounded.
TomlValue convert(const toml::node& node) {
    TomlValue result;
    result.place = place_of(node.source());
    if (const auto* boolean = node.as_boolean()) {
        result.value = boolean->get();
    } else if (const auto* integer = node.as_integer()) {
        result.value = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        result.value = number->get();
    } else if (const auto* text = node.as_string()) {
        result.value = text->get();
    } else if (const auto* array = node.as_array()) {
        TomlValue::Array items;
        items.reserve(array->size());
        for (const toml::node& item : *array) items.push_back(convert(item));
        result.value = std::move(items);
    } else if (const auto* table = node.as_table()) {
        TomlValue::Table entries;
        for (const auto& [key, item] : *table) {
            entries.push_back({std::string(key.str()), place_of(key.source()), convert(item)});
        }
        // In the order of the file, which is the order of materials and of messages.
        std::sort(entries.begin(), entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
            return std::pair(a.key_place.line, a.key_place.column) <
                   std::pair(b.key_place.line, b.key_place.column);
        });
        result.value = std::move(entries);
    }
    return result;
}

struct Describe {
    std::string operator()(std::monostate) const { return "a date or time"; }
    std::string operator()(bool b) const { return b ? "the boolean true" : "the boolean false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("the number {}", i); }
    std::string operator()(double d) const { return fmt::format("the number {}", d); }
    std::string operator()(const std::string& s) const {
        constexpr std::size_t kShown = 40;
        return s.size() <= kShown ? fmt::format("the string \"{}\"", s) : "a long string";
    }
    std::string operator()(const TomlValue::Array& a) const {
        return fmt::format("an array of {}", a.size());
    }
    std::string operator()(const TomlValue::Table&) const { return "a table"; }
};

}  // namespace

std::string describe(const TomlValue& value) { return std::visit(Describe{}, value.value); }

TomlDocument parse_toml(std::string file, std::string text) {
    TomlDocument document{std::move(file), std::move(text), {}, {}};
    try {
        document.root = convert(toml::parse(document.text, document.file));
    } catch (const toml::parse_error& error) {
        const TomlPlace place = place_of(error.source());
        throw InputError({document.file, place.line, place.column, {}},
                         fmt::format("not TOML: {}", error.description()),
                         std::string(line_of(document.text, place.line)));
    }
    return document;
}

}  // namespace dewbow::toml_import
