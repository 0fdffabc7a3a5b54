// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers from text, whatever the locale.

#include <charconv>
#include <optional>
#include <string_view>

namespace dewbow {

/// The number that `text` is, or nothing if it is not wholly one (spaces are not skipped; no
/// hexadecimal). "inf" and "nan" parse as such for floating point: check the range.
template <class T>
std::optional<T> parse_number(std::string_view text) {
    T value{};
    const char* first = text.data();
    const char* last = first + text.size();
    if (text.starts_with('+') && !text.starts_with("+-")) ++first;  // from_chars knows no plus
    const auto [end, status] = std::from_chars(first, last, value);
    if (status != std::errc{} || end != last || first == last) return std::nullopt;
    return value;
}

}  // namespace dewbow
