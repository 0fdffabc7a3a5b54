// SPDX-License-Identifier: Apache-2.0
#include "option_value.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"

namespace dewbow {

namespace {

constexpr int kMaxSide = 65536;
constexpr double kLongestSeconds = 8760.0 * 3600.0;  // a year

/// What stands before and after the first `mark`.
std::optional<std::pair<std::string_view, std::string_view>> split(std::string_view text,
                                                                   char mark) {
    const std::size_t place = text.find(mark);
    if (place == std::string_view::npos) return std::nullopt;
    return std::pair(text.substr(0, place), text.substr(place + 1));
}

std::optional<int> parse_int_in(std::string_view text, int low, int high) {
    const auto value = parse_number<int>(text);
    return value && *value >= low && *value <= high ? value : std::nullopt;
}

std::optional<PictureSize> size_from(std::string_view text) {
    const auto parts = split(text, 'x');
    if (!parts) return std::nullopt;
    const auto width = parse_int_in(parts->first, 1, kMaxSide);
    const auto height = parse_int_in(parts->second, 1, kMaxSide);
    if (!width || !height) return std::nullopt;
    return PictureSize{*width, *height};
}

std::optional<PixelPlace> place_from(std::string_view text) {
    const auto parts = split(text, ',');
    if (!parts) return std::nullopt;
    const auto x = parse_int_in(parts->first, 0, kMaxSide - 1);
    const auto y = parse_int_in(parts->second, 0, kMaxSide - 1);
    if (!x || !y) return std::nullopt;
    return PixelPlace{*x, *y};
}

}  // namespace

void refuse_value(std::string_view option, std::string_view text, std::string_view wanted) {
    const std::string shown =
        parse_number<double>(text) ? std::string(text) : fmt::format("\"{}\"", text);
    throw UsageError(fmt::format("{} is {}; it must be {}", option, shown, wanted));
}

std::int64_t parse_integer(std::string_view option, std::string_view text, std::int64_t low,
                           std::int64_t high) {
    const auto value = parse_number<std::int64_t>(text);
    if (value && *value >= low && *value <= high) return *value;
    refuse_value(option, text,
                 fmt::format("{}{} to {}", value ? "" : "a whole number from ", low, high));
}

std::uint64_t parse_seed(std::string_view option, std::string_view text) {
    const auto value = parse_number<std::uint64_t>(text);
    if (value) return *value;
    refuse_value(
        option, text,
        fmt::format("a whole number from 0 to {}", std::numeric_limits<std::uint64_t>::max()));
}

double parse_real(std::string_view option, std::string_view text, double low, double high) {
    const auto value = parse_number<double>(text);
    if (value && *value >= low && *value <= high) return *value;
    refuse_value(option, text, fmt::format("{}{} to {}", value ? "" : "a number from ", low, high));
}

int parse_packet(std::string_view option, std::string_view text) {
    for (const int lanes : {1, 4, 8, 16})
        if (text == std::to_string(lanes)) return lanes;
    refuse_value(option, text, "1, 4, 8 or 16");
}

PictureSize parse_size(std::string_view option, std::string_view text) {
    if (const auto size = size_from(text)) return *size;
    refuse_value(option, text,
                 fmt::format("WIDTHxHEIGHT such as 1920x1080, each 1 to {} pixels", kMaxSide));
}

PixelRect parse_crop(std::string_view option, std::string_view text) {
    const std::size_t last_comma = text.rfind(',');
    if (last_comma != std::string_view::npos) {
        const auto corner = place_from(text.substr(0, last_comma));
        const auto size = size_from(text.substr(last_comma + 1));
        if (corner && size)
            return {corner->x, corner->y, corner->x + size->width, corner->y + size->height};
    }
    refuse_value(
        option, text,
        "X,Y,WIDTHxHEIGHT such as 100,50,640x360, the upper left corner and the size in pixels");
}

PixelPlace parse_pixel(std::string_view option, std::string_view text) {
    if (const auto place = place_from(text)) return *place;
    refuse_value(option, text, fmt::format("X,Y such as 12,7, each 0 to {}", kMaxSide - 1));
}

SliceOf parse_slice(std::string_view option, std::string_view text) {
    constexpr int kMostSlices = 1'000'000;
    if (const auto parts = split(text, '/')) {
        const auto count = parse_int_in(parts->second, 1, kMostSlices);
        const auto number = count ? parse_int_in(parts->first, 1, *count) : std::nullopt;
        if (number) return {static_cast<std::size_t>(*number), static_cast<std::size_t>(*count)};
    }
    refuse_value(option, text, fmt::format("K/N such as 2/8, N 1 to {} and K 1 to N", kMostSlices));
}

std::chrono::duration<double> parse_duration(std::string_view option, std::string_view text) {
    constexpr std::pair<char, double> kUnits[] = {{'s', 1.0}, {'m', 60.0}, {'h', 3600.0}};
    std::string_view number = text;
    double seconds_per_unit = 1.0;
    for (const auto& [unit, seconds] : kUnits) {
        if (!text.ends_with(unit)) continue;
        number.remove_suffix(1);
        seconds_per_unit = seconds;
    }
    const double seconds = parse_number<double>(number).value_or(-1.0) * seconds_per_unit;
    if (seconds > 0.0 && seconds <= kLongestSeconds) return std::chrono::duration<double>(seconds);
    refuse_value(option, text, "a time such as 30s, 2m or 1h, above 0 and at most 8760h");
}

std::string parse_file_name(std::string_view option, std::string_view text,
                            std::span<const std::string> extensions) {
    std::string extension = std::filesystem::path(text).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    std::string endings;
    for (const std::string& known : extensions) {
        if (extension == known) return std::string(text);
        endings += (endings.empty() ? "" : " or ") + known;
    }
    refuse_value(option, text, "a file name that ends in " + endings);
}

PlotRequest parse_plot(std::string_view option, std::string_view text,
                       std::span<const PlotKind> kinds) {
    const auto parts = split(text, '=');
    if (!parts || parts->first.empty() || parts->second.empty())
        throw UsageError(fmt::format("{} is \"{}\"; it must be KIND=FILE", option, text),
                         fmt::format("for instance {} {}=curve.svg", option, kinds.front().name));
    std::vector<std::string> names;
    for (const PlotKind& kind : kinds) {
        if (kind.name == parts->first)
            return {kind.name, parse_file_name(option, parts->second, kind.endings)};
        names.push_back(kind.name);
    }
    throw UsageError(fmt::format("{} is \"{}\": unknown plot \"{}\"", option, text, parts->first),
                     hint_for(parts->first, names));
}

std::size_t parse_word(std::string_view option, std::string_view text,
                       std::span<const std::string> words) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == text) return i;
    throw UsageError(fmt::format("{} is \"{}\", which is none of its words", option, text),
                     hint_for(text, words));
}

GlassOverride parse_glass_override(std::string_view option, std::string_view text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size())
        throw UsageError(fmt::format("{} is {}; it must be MATERIAL=GLASS", option, text),
                         "for instance --glass Diamond=gem/diamond");
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

}  // namespace dewbow
