// SPDX-License-Identifier: Apache-2.0
#pragma once

// From partial waves to amplitudes by angle.

#include <span>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/mie/partial_waves.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// S_1 = Σ c_n (a_n π_n + b_n τ_n), S_2 = Σ c_n (a_n τ_n + b_n π_n), c_n = (2n+1) / (n(n+1)), of
/// several spheres at angles 0 to 180° in any order, into `out`: [sphere][angle], row-major.
///                                                                  [Bohren & Huffman 1983,
///                                                                  eq. 4.74]
void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out);

}  // namespace dewbow
