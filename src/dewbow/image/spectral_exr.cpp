// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/spectral_exr.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/parse_number.h"

namespace dewbow {
namespace {

/// Speed of light in vacuum, exact. [SI Brochure, 9th edition, 2019]
constexpr double kSpeedOfLightMPerS = 299792458.0;
constexpr int kNmPerMetreExponent = 9;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t skip_digits(std::string_view text, std::size_t from) {
    while (from < text.size() && is_digit(text[from])) ++from;
    return from;
}

/// Length of the longest `\d*,?\d*([Ee][+-]?\d+)?` that `text` begins with.
std::size_t number_length(std::string_view text) {
    std::size_t end = skip_digits(text, 0);
    if (end < text.size() && text[end] == ',') end = skip_digits(text, end + 1);
    if (end == text.size() || (text[end] != 'E' && text[end] != 'e')) return end;
    std::size_t exponent = end + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    const std::size_t exponent_end = skip_digits(text, exponent);
    // "5Em" is five exametres: without digits, E is no exponent.
    return exponent_end > exponent ? exponent_end : end;
}

std::optional<double> number_with_comma(std::string_view text) {
    std::string with_point(text);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return parse_number<double>(with_point);
}

/// Takes `unit` off the end of `text` if it stands there.
bool remove_suffix(std::string_view& text, std::string_view suffix) {
    if (!text.ends_with(suffix)) return false;
    text.remove_suffix(suffix.size());
    return true;
}

/// The power of ten that an SI prefix of the layout stands for; none is 0.
std::optional<int> prefix_exponent(std::string_view prefix) {
    struct Row {
        std::string_view prefix;
        int exponent;
    };
    constexpr Row kRows[] = {{"", 0},   {"Y", 24}, {"Z", 21}, {"E", 18}, {"P", 15}, {"T", 12},
                             {"G", 9},  {"M", 6},  {"k", 3},  {"h", 2},  {"da", 1}, {"d", -1},
                             {"c", -2}, {"m", -3}, {"u", -6}, {"n", -9}, {"p", -12}};
    for (const Row& row : kRows)
        if (row.prefix == prefix) return row.exponent;
    return std::nullopt;
}

/// value * 10^exponent. One rounding for |exponent| <= 22, where 10^|exponent| is exact.
double scaled(double value, int exponent) {
    return exponent >= 0 ? value * std::pow(10.0, exponent) : value / std::pow(10.0, -exponent);
}

}  // namespace

std::string emissive_channel_name(Wavelength centre) {
    std::string name = fmt::format("S0.{:f}nm", centre.to(unit::nm));
    std::replace(name.begin() + 3, name.end(), '.', ',');
    return name;
}

std::optional<Wavelength> emissive_channel_wavelength(std::string_view name) {
    constexpr std::string_view kPrefix = "S0.";
    if (!name.starts_with(kPrefix)) return std::nullopt;
    name.remove_prefix(kPrefix.size());

    const std::size_t length = number_length(name);
    const std::optional<double> number = number_with_comma(name.substr(0, length));
    std::string_view unit_text = name.substr(length);
    const bool hertz = remove_suffix(unit_text, "Hz");
    if (!hertz && !remove_suffix(unit_text, "m")) return std::nullopt;
    const std::optional<int> exponent = prefix_exponent(unit_text);
    if (!number || !exponent) return std::nullopt;

    const double lambda_nm =
        hertz ? scaled(kSpeedOfLightMPerS / *number, kNmPerMetreExponent - *exponent)
              : scaled(*number, kNmPerMetreExponent + *exponent);
    if (!std::isfinite(lambda_nm) || lambda_nm <= 0.0) return std::nullopt;
    return lambda_nm * unit::nm;
}

Attributes spectral_attributes() {
    return {{"spectralLayoutVersion", "1.0"}, {"emissiveUnits", "W.m^-2.sr^-1"}, {"EV", 0.0}};
}

}  // namespace dewbow
