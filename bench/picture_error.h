// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far a noisy picture lies from the true one.

#include <string>
#include <vector>

#include "dewbow/spectrum/colour.h"

namespace dewbow::bench {

/// Row by row; white = Y 1.
using Picture = std::vector<Colour<Xyz>>;

/// Mean squared errors, each over pixels and over the numbers of a pixel.
struct PictureError {
    double srgb = 0.0;     ///< linear sRGB
    double xyz = 0.0;      ///< X, Y, Z
    double y = 0.0;        ///< Y alone
    double colour = 0.0;   ///< X − Y and Z − Y: what is no error of brightness
    double trimmed = 0.0;  ///< linear sRGB without the worst kTrimmedShare of the pixels
};
/// Fireflies: the share of the pixels that `trimmed` leaves out.
inline constexpr double kTrimmedShare = 1e-3;

struct ErrorColumn {
    std::string name;
    double PictureError::*value;
};
const std::vector<ErrorColumn>& error_columns();

PictureError error_between(const Picture& a, const Picture& b);

/// A reference of two halves, rendered independently.
struct Reference {
    Picture mean;
    /// Error of `mean` itself: that between the halves, over 4.
    PictureError own;
};
Reference make_reference(const Picture& first, const Picture& second);

/// Error of `picture`, less that of the reference. The two are independent, so that their errors
/// add up (for `trimmed` nearly). Not below zero.
PictureError error_against(const Reference& reference, const Picture& picture);

double median(std::vector<double> values);

}  // namespace dewbow::bench
