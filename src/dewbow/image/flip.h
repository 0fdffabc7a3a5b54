// SPDX-License-Identifier: Apache-2.0
#pragma once

// ꟻLIP: how different two pictures look to somebody who flips between them.
// [Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild, "FLIP: A Difference Evaluator
// for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020]

#include <vector>

#include "dewbow/image/image.h"

namespace dewbow {

/// Pixels per degree of a display 0.7 m wide with 3840 pixels, seen from 0.7 m.   [ibid., §4]
inline constexpr double kFlipPixelsPerDegree = 67.0206432765823;

/// Difference of each pixel, 0 (none) to 1, row by row. Pictures of low dynamic range: channels R,
/// G and B are linear sRGB and are clamped to [0, 1] first; what is not finite counts as 0. Beyond
/// the picture's edge its outermost pixels go on. Throws InputError if the sizes differ or one
/// lacks R, G or B.
/// @param pixels_per_degree  of the display and its distance, > 0.
std::vector<double> flip(const Image& image, const Image& reference,
                         double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace dewbow
