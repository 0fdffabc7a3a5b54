// SPDX-License-Identifier: Apache-2.0
#pragma once

// From scene-linear XYZ to what a screen shows: exposure, white, gamut, transfer curve, dither.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/spectrum/colour.h"

namespace dewbow {

/// How a colour outside the display's gamut is brought into it.
enum class GamutMapping {
    clip,          ///< negative channels to zero: brighter and shifted in hue
    towards_white  ///< towards white at constant luminance until no channel is negative
};
std::vector<std::string> gamut_mapping_names();
/// Throws InputError with the nearest right word.
GamutMapping gamut_mapping_from_name(std::string_view name);

/// Maps `rgb` so that no channel is negative. Channels above 1 stay (they are the exposure's
/// business).
template <class Space>
Colour<Space> map_gamut(Colour<Space> rgb, GamutMapping mapping);

/// sRGB's curve, both ways (IEC 61966-2-1); odd symmetric for negative values.
double srgb_encode(double linear);
double srgb_decode(double encoded);

struct DisplaySettings {
    double exposure_stops = 0.0;
    /// Chromaticity that is to look white; the default leaves D65 white.
    std::array<double, 2> white{0.3127, 0.3290};
    GamutMapping gamut = GamutMapping::towards_white;
    bool dither =
        true;  ///< else code values are rounded: smaller files, and steps in dark gradients
};

/// 8-bit sRGB of a pixel. A colour with a channel above 1 is desaturated towards white at constant
/// luminance until it fits; where the luminance itself is above 1 it is white. Triangular dither of
/// ±1 code value keyed by (x, y), the same each time; exact black and white are not dithered.
/// @param xyz  scene-linear, Y = 1 is display white at exposure 0.
std::array<std::uint8_t, 3> srgb8_from_xyz(Colour<Xyz> xyz, const DisplaySettings& settings, int x,
                                           int y);

/// CIEDE2000 colour difference of two colours under white `white_xyz` (Y = 1).
/// [Sharma, Wu & Dalal 2005]
double delta_e_2000(Colour<Xyz> a, Colour<Xyz> b, Colour<Xyz> white_xyz);

}  // namespace dewbow
