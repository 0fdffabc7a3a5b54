// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/display.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/base/random.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

struct GamutMappingRow {
    std::string_view name;
    GamutMapping mapping;
};
constexpr std::array kGamutMappings{
    GamutMappingRow{"clip", GamutMapping::clip},
    GamutMappingRow{"towards_white", GamutMapping::towards_white},
};

/// `rgb` moved towards the grey `luminance`: 1 leaves it, 0 gives the grey.
template <class Space>
Colour<Space> around_grey(Colour<Space> rgb, double luminance, double saturation) {
    for (double& channel : rgb.v) channel = luminance + saturation * (channel - luminance);
    return rgb;
}

template <class Space>
Colour<Space> clip_negative(Colour<Space> rgb) {
    for (double& channel : rgb.v) channel = channel > 0.0 ? channel : 0.0;
    return rgb;
}

template <class Space>
Colour<Space> lift_negative_towards_white(Colour<Space> rgb) {
    const double lowest = std::min({rgb[0], rgb[1], rgb[2]});
    if (lowest >= 0.0) return rgb;
    const double luminance = xyz_from_rgb(rgb)[1];
    if (!(luminance > 0.0)) return {};
    // What rounding leaves below zero is clipped.
    return clip_negative(around_grey(rgb, luminance, luminance / (luminance - lowest)));
}

/// Channels above 1 brought to 1 towards white at constant luminance; white where that is above 1.
Colour<LinearSrgb> fit_below_one(Colour<LinearSrgb> rgb) {
    const double highest = std::max({rgb[0], rgb[1], rgb[2]});
    if (highest <= 1.0) return rgb;
    const double luminance = xyz_from_rgb(rgb)[1];
    if (luminance >= 1.0) return {{1.0, 1.0, 1.0}};
    return around_grey(rgb, luminance, (1.0 - luminance) / (highest - luminance));
}

/// Two numbers in [0, 1) that belong to one channel of one pixel.
std::array<double, 2> dither_numbers(int x, int y, std::uint32_t channel) {
    const std::uint64_t pixel = (std::uint64_t{std::uint32_t(y)} << 32) | std::uint32_t(x);
    const std::uint64_t bits = hash_combine(mix_bits(pixel + 1), channel);
    constexpr double kTo01 = 1.0 / 4294967296.0;
    return {double(bits >> 32) * kTo01, double(bits & 0xffffffffu) * kTo01};
}

/// `encoded` in [0, 1] as a code value whose mean over dithers is 255 × encoded.
/// Triangular dither; in the outermost half code values, where it would leave the range and so
/// shift the mean, uniform dither between the two codes there: exact black and white stay as they
/// are.
std::uint8_t dithered_code(double encoded, std::array<double, 2> random) {
    const double code = 255.0 * encoded;
    const bool at_end = code < 0.5 || code > 254.5;
    const double shifted = at_end ? code + random[0] : code + random[0] - random[1] + 0.5;
    return std::uint8_t(std::clamp(std::floor(shifted), 0.0, 255.0));
}

}  // namespace

std::vector<std::string> gamut_mapping_names() {
    std::vector<std::string> names;
    for (const GamutMappingRow& row : kGamutMappings) names.emplace_back(row.name);
    return names;
}

GamutMapping gamut_mapping_from_name(std::string_view name) {
    for (const GamutMappingRow& row : kGamutMappings) {
        if (row.name == name) return row.mapping;
    }
    const auto names = gamut_mapping_names();
    throw InputError("unknown gamut mapping \"" + std::string(name) + "\"", hint_for(name, names));
}

template <class Space>
Colour<Space> map_gamut(Colour<Space> rgb, GamutMapping mapping) {
    switch (mapping) {
        case GamutMapping::clip:
            return clip_negative(rgb);
        case GamutMapping::towards_white:
            return lift_negative_towards_white(rgb);
    }
    return rgb;
}
template Colour<LinearSrgb> map_gamut(Colour<LinearSrgb>, GamutMapping);
template Colour<LinearRec2020> map_gamut(Colour<LinearRec2020>, GamutMapping);
template Colour<LinearDisplayP3> map_gamut(Colour<LinearDisplayP3>, GamutMapping);
template Colour<AcesCg> map_gamut(Colour<AcesCg>, GamutMapping);

double srgb_encode(double linear) {
    const double size = std::abs(linear);
    const double encoded =
        size <= 0.0031308 ? 12.92 * size : 1.055 * std::pow(size, 1.0 / 2.4) - 0.055;
    return std::copysign(encoded, linear);
}

double srgb_decode(double encoded) {
    const double size = std::abs(encoded);
    const double linear = size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4);
    return std::copysign(linear, encoded);
}

std::array<std::uint8_t, 3> srgb8_from_xyz(Colour<Xyz> xyz, const DisplaySettings& settings, int x,
                                           int y) {
    const auto display_white = primaries_of<LinearSrgb>().white;
    if (settings.white != display_white) xyz = adapt_white(xyz, settings.white, display_white);
    const auto exposed = rgb_from_xyz<LinearSrgb>(xyz * std::exp2(settings.exposure_stops));
    const auto shown = fit_below_one(map_gamut(exposed, settings.gamut));
    std::array<std::uint8_t, 3> codes{};
    for (std::uint32_t c = 0; c < 3; ++c) {
        const double encoded = std::clamp(srgb_encode(clip_negative(shown)[c]), 0.0, 1.0);
        codes[c] = settings.dither ? dithered_code(encoded, dither_numbers(x, y, c))
                                   : std::uint8_t(std::lround(255.0 * encoded));
    }
    return codes;
}

}  // namespace dewbow
