// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far one picture is from another, in the numbers that benchmarks and tests quote.

#include "dewbow/image/image.h"

namespace dewbow {

/// Over the channels R, G and B of all pixels, with a the picture's and b the reference's value.
struct ImageDifference {
    /// Mean of (a - b)²: in the picture's unit, squared.
    double mean_squared = 0.0;
    /// Mean of (a - b)² / (b² + f²), f the floor below which differences count as absolute.
    double relative_mean_squared = 0.0;
    /// The pixel with the largest |a - b| in any of its three channels (the first, row by row, of
    /// several), and that difference. A value that is not finite is an infinite difference.
    int worst_x = 0, worst_y = 0;
    double worst = 0.0;
};

/// Compares `image` with `reference`. A value that is not finite in either makes both means
/// infinite. Throws InputError if the sizes differ or one lacks R, G or B.
/// @param floor  f, in the pictures' unit, > 0. The default suits references whose mean is about
///               one; scale it with the exposure.
ImageDifference compare_rgb(const Image& image, const Image& reference, double floor = 0.1);

}  // namespace dewbow
