// SPDX-License-Identifier: Apache-2.0
#pragma once

// What an eye tells apart in a picture: S-CIELAB, with CIEDE2000 as its measure.
// [X. Zhang, B. Wandell. A spatial extension of CIELAB for digital color-image reproduction. SID
// Journal 5(1), 1997; G. M. Johnson, M. D. Fairchild. A top down description of S-CIELAB and
// CIEDE2000. Color Res. Appl. 28(6), 2003]

#include <span>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/matrix3.h"

namespace dewbow::bench {

/// Black–white, red–green and blue–yellow: the channels that the eye blurs, each by its own width.
struct Opponent {};

Colour<Opponent> opponent_from_xyz(Colour<Xyz> xyz);

/// A part of a channel's blur: a Gaussian around the line of sight.
struct Lobe {
    double weight = 0.0;        ///< those of a channel sum to 1
    double sigma_arcmin = 0.0;  ///< standard deviation in each direction
};
std::span<const Lobe> lobes(std::size_t channel);

/// The narrowest of them.
double sharpest_arcmin();

/// CIEDE2000 between two blurred colours, white = (1, 1, 1) of linear sRGB, both under a veil of
/// kFlare of white.
double visible_difference(Colour<Opponent> a, Colour<Opponent> b);

/// What a screen shows where it is black.          [IEC 61966-2-1: encoding viewing flare 1.0 %]
inline constexpr double kFlare = 0.01;

/// From here on a difference counts as visible: about what half of the observers find in large
/// fields side by side, the best conditions that there are. Twice as much passes unnoticed in most
/// pictures.
inline constexpr double kJustVisible = 1.0;

/// Covariance of what is seen at the middle of a square pixel when each pixel has noise of its own
/// with covariance `of_pixel` (in opponent channels).
Matrix3 seen_covariance(const Matrix3& of_pixel, double pixel_arcmin);

/// Root mean square of visible_difference between `mean` and itself with noise of `covariance`.
double rms_difference(Colour<Opponent> mean, const Matrix3& covariance);

}  // namespace dewbow::bench
