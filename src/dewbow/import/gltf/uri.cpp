// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/uri.h"

#include <array>
#include <cstdint>

namespace dewbow::gltf {
namespace {

constexpr std::string_view kScheme = "data:";
constexpr std::string_view kBase64Mark = ";base64,";
constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Value of each byte as a base64 digit, −1 for others.
constexpr std::array<int, 256> make_digits() {
    std::array<int, 256> digits{};
    digits.fill(-1);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
        digits[static_cast<unsigned char>(kAlphabet[i])] = int(i);
    }
    return digits;
}
constexpr std::array<int, 256> kDigits = make_digits();

std::optional<std::string> decode_base64(std::string_view text) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = kDigits[static_cast<unsigned char>(c)];
        if (digit < 0) return std::nullopt;
        bits = (bits << 6) | std::uint32_t(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(char((bits >> count) & 0xff));
    }
    return bytes;
}

int hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with(kScheme); }

std::optional<std::string> decode_data_uri(std::string_view uri) {
    const std::size_t mark = uri.find(kBase64Mark);
    if (!is_data_uri(uri) || mark == std::string_view::npos || mark > uri.find(','))
        return std::nullopt;
    return decode_base64(uri.substr(mark + kBase64Mark.size()));
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            result.push_back(text[i]);
            continue;
        }
        if (text.size() - i < 3) return std::nullopt;
        const int high = hexadecimal(text[i + 1]), low = hexadecimal(text[i + 2]);
        if (high < 0 || low < 0 || (high == 0 && low == 0)) return std::nullopt;
        result.push_back(char(high * 16 + low));
        i += 2;
    }
    return result;
}

}  // namespace dewbow::gltf
