// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far a contestant's picture lies from another, in the numbers that reports quote.

#include <string>
#include <vector>

#include "picture.h"

namespace dewbow::bench {

/// Which pixels count.
using Mask = std::vector<bool>;

/// Means over the pixels of a mask and their three numbers; a the picture's, b the reference's.
struct PictureErrors {
    double mse = 0.0;           ///< (a − b)² of linear sRGB, white = 1
    double relative_mse = 0.0;  ///< (a − b)² / (b² + f²), f = kFloor
    double trimmed = 0.0;       ///< the same without the kTrimmedShare of the pixels that are worst
    double xyz_mse = 0.0;       ///< (a − b)² of X, Y, Z, white has Y = 1
    double clipped = 0.0;       ///< (a − b)² of linear sRGB, both cut off at kBrightest first
    double flip = 0.0;          ///< FLIP of the pictures as a screen shows them, 0 to 1
};
/// Below this share of white differences count as absolute.
inline constexpr double kFloor = 0.1;
/// Brighter than this a screen shows nothing that the eye tells apart; white = 1.
inline constexpr double kBrightest = 2.0;
/// Fireflies: what `trimmed` leaves out, rounded down to whole pixels.
inline constexpr double kTrimmedShare = 1e-3;

struct ErrorKind {
    std::string name;
    double PictureErrors::*value;
    bool squared;  ///< errors of independent pictures add up, so that the reference's can be taken
                   ///< away
};
const std::vector<ErrorKind>& error_kinds();

/// A reference of two independent halves.
struct Reference {
    Picture mean;
    Picture
        half_difference;  ///< half of the halves' difference: about as large as the error of `mean`
};
/// Throws InputError if the sizes differ.
Reference make_reference(const Picture& first, const Picture& second);
/// Errors of the reference itself, as far as they are squares; others are 0.
PictureErrors own_errors(const Reference& reference, const Mask& mask);

/// A picture beside a reference. Throws InputError if the sizes differ. Values that are not finite
/// count as infinite errors.
class Comparison {
public:
    Comparison(const Picture& picture, const Reference& reference);
    /// Errors less those of the reference (squares alone), not below zero; zeros for an empty mask.
    PictureErrors errors(const Mask& mask) const;

private:
    const Reference* reference_;
    std::vector<Colour<LinearSrgb>> differences_;
    std::vector<double> flip_;
};

struct NamedMask {
    std::string name, description;
    Mask mask;
};
/// "whole"; and "coloured": where light has come apart. Made of the reference alone.
std::vector<NamedMask> make_masks(const Picture& reference);
/// The same of the pixels of `seen` alone; and "caustic": where the reference is brighter than
/// `direct`, which is light straight from the lamps.
std::vector<NamedMask> make_masks(const Picture& reference, const Picture& direct,
                                  const Mask& seen);

/// Mean over a mask.
Colour<LinearSrgb> mean_colour(const Picture& picture, const Mask& mask);

/// The image that a picture is, with channels R, G, B.
Image image_of(const Picture& picture);

double median(std::vector<double> values);

}  // namespace dewbow::bench
