// SPDX-License-Identifier: Apache-2.0
#pragma once

// RGB spaces, and the smooth spectra that RGB numbers of other people's scenes stand for.

#include <array>
#include <string_view>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// Chromaticities of a space's primaries and white, with its name as it stands in files.
struct RgbPrimaries {
    std::string_view name;
    std::array<double, 2> red, green, blue, white;
};
template <class Space>
const RgbPrimaries& primaries_of();
template <>
const RgbPrimaries& primaries_of<LinearSrgb>();
template <>
const RgbPrimaries& primaries_of<LinearRec2020>();
template <>
const RgbPrimaries& primaries_of<LinearDisplayP3>();
template <>
const RgbPrimaries& primaries_of<AcesCg>();

/// Conversions by the matrix of the primaries; white (1,1,1) ↔ Y = 1. Not clamped.
template <class Space>
Colour<Xyz> xyz_from_rgb(Colour<Space> rgb);
template <class Space>
Colour<Space> rgb_from_xyz(Colour<Xyz> xyz);
// (instantiated for the four spaces above in rgb.cpp)

/// Chromatic adaptation by Bradford's matrix: what looks under white `to` as `xyz` looks under
/// `from`.
Colour<Xyz> adapt_white(Colour<Xyz> xyz, std::array<double, 2> from_white,
                        std::array<double, 2> to_white);

/// A smooth reflectance in [0, 1] that under D65 has the colour `rgb`.
/// [Jakob & Hanika 2019: sigmoid of a quadratic in wavelength; the three coefficients are solved
/// here by Gauss–Newton in CIE L*a*b* for the one colour, no table.] Equal channels give an exactly
/// constant spectrum. Components are clamped to [0, 1].
SpectrumPtr make_reflectance(Colour<LinearSrgb> rgb);

/// An emission spectrum of colour and brightness `rgb`, white = D65: scale × reflectance × D65,
/// such that its Y is that of `rgb` with (1,1,1) as bright as the constant spectrum 1.
SpectrumPtr make_emission(Colour<LinearSrgb> rgb);

/// What light makes of a colour-neutral scale: a transmittance colour at unit depth turned into an
/// absorption coefficient spectrum −ln(T)/depth; T is kept above 1e-6.
SpectrumPtr make_absorption(Colour<LinearSrgb> transmittance, Length depth);

}  // namespace dewbow
