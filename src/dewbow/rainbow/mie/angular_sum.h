// SPDX-License-Identifier: Apache-2.0
#pragma once

// From partial waves to amplitudes by angle.

#include <complex>
#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Amplitudes of the partial waves that a sphere scatters, a_n (electric) and b_n (magnetic), of
/// order n = 1..N at [n − 1].                                        [Bohren & Huffman 1983,
/// eq. 4.53]
struct PartialWaves {
    std::vector<std::complex<double>> a, b;
};

/// S_1 = Σ c_n (a_n π_n + b_n τ_n), S_2 = Σ c_n (a_n τ_n + b_n π_n), c_n = (2n+1) / (n(n+1)), of
/// several spheres at angles 0 to 180° in any order, into `out`: [sphere][angle], row-major.
///                                                                  [Bohren & Huffman 1983,
///                                                                  eq. 4.74]
void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out);

}  // namespace dewbow
