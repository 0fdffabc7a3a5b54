// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/glass/agf_text.h"

#include <algorithm>

#include "dewbow/base/error.h"

namespace dewbow::glass_import {
namespace {

enum class Encoding { bytes, utf16_little, utf16_big };

constexpr char32_t kNextLine = 0x85;
constexpr std::size_t kLooksAt = 4096;  ///< bytes that show whether there are marks missing

/// UTF-16 of a Latin text has a zero in every second byte.
Encoding encoding_without_mark(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, kLooksAt);
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < start.size(); ++i)
        if (start[i] == '\0') ++zeros[i % 2];
    const std::size_t enough = start.size() / 4 + 1;
    if (zeros[1] >= enough && zeros[0] == 0) return Encoding::utf16_little;
    if (zeros[0] >= enough && zeros[1] == 0) return Encoding::utf16_big;
    return Encoding::bytes;
}

void append_utf8(std::string& text, char32_t c) {
    if (c < 0x80) {
        text.push_back(static_cast<char>(c));
    } else if (c < 0x800) {
        text.push_back(static_cast<char>(0xC0 | (c >> 6)));
        text.push_back(static_cast<char>(0x80 | (c & 0x3F)));
    } else {
        text.push_back(static_cast<char>(0xE0 | (c >> 12)));
        text.push_back(static_cast<char>(0x80 | ((c >> 6) & 0x3F)));
        text.push_back(static_cast<char>(0x80 | (c & 0x3F)));
    }
}

/// Code units of 16 bits; a surrogate, which no glass is named with, becomes a question mark.
std::u32string units_of_utf16(std::string_view bytes, bool little) {
    std::u32string units;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const auto low = static_cast<unsigned char>(bytes[i + (little ? 0 : 1)]);
        const auto high = static_cast<unsigned char>(bytes[i + (little ? 1 : 0)]);
        const char32_t unit = static_cast<char32_t>(high) << 8 | low;
        units.push_back(unit >= 0xD800 && unit < 0xE000 ? U'?' : unit);
    }
    return units;
}

/// How many bytes the UTF-8 sequence at the front of `text` has, or 0 if there is none.
std::size_t utf8_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80         ? 1
                               : first >> 5 == 0x06 ? 2
                               : first >> 4 == 0x0E ? 3
                               : first >> 3 == 0x1E ? 4
                                                    : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
    return length;
}

/// Bytes that are no UTF-8 are taken for Latin-1.
std::u32string units_of_bytes(std::string_view bytes) {
    std::u32string units;
    while (!bytes.empty()) {
        const std::size_t length = utf8_length(bytes);
        const auto first = static_cast<unsigned char>(bytes[0]);
        char32_t unit = first;
        if (length > 1) unit = first & (0xFF >> (length + 1));
        for (std::size_t i = 1; i < length; ++i)
            unit = unit << 6 | (static_cast<unsigned char>(bytes[i]) & 0x3F);
        units.push_back(unit > 0xFFFF ? U'?' : unit);
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return units;
}

}  // namespace

TextLines lines_of_text(std::string_view bytes) {
    TextLines result;
    Encoding encoding = Encoding::bytes;
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        encoding = bytes[0] == '\xFF' ? Encoding::utf16_little : Encoding::utf16_big;
        bytes.remove_prefix(2);
    } else if (bytes.starts_with("\xEF\xBB\xBF")) {
        bytes.remove_prefix(3);
    } else {
        encoding = encoding_without_mark(bytes);
    }
    const bool little = encoding == Encoding::utf16_little;
    const std::u32string units =
        encoding == Encoding::bytes ? units_of_bytes(bytes) : units_of_utf16(bytes, little);
    if (encoding != Encoding::bytes)
        result.findings.push_back(little ? "the text is UTF-16, little-endian"
                                         : "the text is UTF-16, big-endian");
    if (units.find(U'\0') != std::u32string::npos)
        throw InputError("not a text: it has zero bytes");
    if (units.find(kNextLine) != std::u32string::npos)
        result.findings.push_back("lines end with NEL (U+0085)");

    std::string line;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const char32_t c = units[i];
        if (c != U'\n' && c != U'\r' && c != kNextLine) {
            append_utf8(line, c);
            continue;
        }
        result.lines.push_back(std::move(line));
        line.clear();
        if (c == U'\r' && i + 1 < units.size() &&
            (units[i + 1] == U'\n' || units[i + 1] == kNextLine))
            ++i;
    }
    if (!line.empty()) result.lines.push_back(std::move(line));
    return result;
}

}  // namespace dewbow::glass_import
