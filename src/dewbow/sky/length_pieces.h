// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arithmetic with lengths that are linear by pieces.

#include <span>
#include <vector>

#include "dewbow/sky/rain_region.h"

namespace dewbow {

/// a + sign · b, where both cover the same stretch of a line without gap; nowhere below 0.
/// Lengths are finite, or infinite in both and then so in the sum.
std::vector<LengthPiece> sum_of(std::span<const LengthPiece> a, std::span<const LengthPiece> b,
                                double sign = 1.0);

/// The same function of s = factor · (distance in `pieces`), factor > 0.
void scale_distance(std::span<LengthPiece> pieces, double factor);

/// Ways without end made 0: light that has come infinitely far through rain is taken to be what
/// arrives in it.
void drop_endless(std::span<LengthPiece> pieces);

}  // namespace dewbow
