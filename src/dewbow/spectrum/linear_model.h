// SPDX-License-Identifier: Apache-2.0
#pragma once

// The linear spectrum of Musgrave 1989, 4.2.1: a stand-in for the colours of monochromatic light
// that needs no colour science. Not colorimetric; it is here so that the paper can be repeated.

#include <array>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectral_coordinate.h"

namespace dewbow {

/// The paper's visible range.
inline constexpr Wavelength kPaperRed = 800.0 * unit::nm, kPaperViolet = 380.0 * unit::nm;
/// Its intervals, with a sample in the middle of each.
inline constexpr int kPaperSamples = 13;
/// What the 13 samples sum to, in each channel.
inline constexpr double kPaperWhite = 6.0;

/// λ and f of the coordinate over that range.
Wavelength paper_wavelength(double f, SpectralSpacing spacing);
double paper_coordinate(Wavelength lambda, SpectralSpacing spacing);

/// The monitor's red, green and blue at f: piecewise linear between the bounds of the 13 intervals,
/// 0 to 1, black at both ends and outside.
/// The figure (4.1) is lost; these curves show all that the text says about it, and samples at any
/// common offset within the intervals sum to kPaperWhite in each channel.
Colour<LinearSrgb> linear_spectrum_colour(double f);

/// The colours in the middle of the intervals, from red to violet.
std::array<Colour<LinearSrgb>, kPaperSamples> linear_spectrum_samples();

}  // namespace dewbow
