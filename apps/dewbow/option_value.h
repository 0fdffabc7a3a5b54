// SPDX-License-Identifier: Apache-2.0
#pragma once

// The values of options, from text. Each throws UsageError, which names the option, the text and
// what it must be: "--spp is 0; it must be 1 to 16777216".

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "command.h"
#include "plot_request.h"

namespace dewbow {

/// Throws UsageError: "`option` is `text`; it must be `wanted`".
[[noreturn]] void refuse_value(std::string_view option, std::string_view text,
                               std::string_view wanted);

std::int64_t parse_integer(std::string_view option, std::string_view text, std::int64_t low,
                           std::int64_t high);
std::uint64_t parse_seed(std::string_view option, std::string_view text);
double parse_real(std::string_view option, std::string_view text, double low, double high);

/// A number of wavelengths: 1, 4, 8 or 16.
int parse_packet(std::string_view option, std::string_view text);

/// "1920x1080"
PictureSize parse_size(std::string_view option, std::string_view text);
/// "X,Y,WxH"
PixelRect parse_crop(std::string_view option, std::string_view text);
/// "X,Y"
struct PixelPlace {
    int x = 0, y = 0;
};
PixelPlace parse_pixel(std::string_view option, std::string_view text);
/// "K/N", 1 <= K <= N.
struct SliceOf {
    std::size_t number = 1, count = 1;
};
SliceOf parse_slice(std::string_view option, std::string_view text);
/// "30s", "1.5m", "2h"; a number alone is seconds.
std::chrono::duration<double> parse_duration(std::string_view option, std::string_view text);

/// The name of a file that ends in one of `extensions` (".exr"), in letters of either case.
std::string parse_file_name(std::string_view option, std::string_view text,
                            std::span<const std::string> extensions);

/// "MATERIAL=GLASS", divided at the last "=".
GlassOverride parse_glass_override(std::string_view option, std::string_view text);

/// "KIND=FILE", one of `kinds` and a file of its endings.
PlotRequest parse_plot(std::string_view option, std::string_view text,
                       std::span<const PlotKind> kinds);

/// The index of `text` in `words`.
std::size_t parse_word(std::string_view option, std::string_view text,
                       std::span<const std::string> words);

}  // namespace dewbow
