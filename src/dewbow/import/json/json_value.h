// SPDX-License-Identifier: Apache-2.0
#pragma once

// A JSON document as a small tree of our own, so that only one file sees the parser.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dewbow {

struct JsonMember;

struct JsonValue {
    using Array = std::vector<JsonValue>;
    using Object = std::vector<JsonMember>;

    /// monostate: null. Numbers are double: whole ones are exact up to 2⁵³.
    std::variant<std::monostate, bool, double, std::string, Array, Object> value;
};

struct JsonMember {
    std::string key;
    JsonValue value;
};

/// Deepest nesting, and most values, that are taken.
inline constexpr std::size_t kMaxJsonDepth = 128;
inline constexpr std::size_t kMaxJsonValues = std::size_t{1} << 24;

/// Throws InputError with line and column where `text` is no JSON, is nested too deeply or too
/// long.
JsonValue parse_json(const std::string& file, std::string_view text);

}  // namespace dewbow
