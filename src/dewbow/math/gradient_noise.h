// SPDX-License-Identifier: Apache-2.0
#pragma once

// Smooth noise: the one band from which fractal ground and turbulence are summed.

#include <cstdint>

#include "dewbow/math/vector.h"

namespace dewbow {

/// Gradient noise: 0 at the points of the integer lattice, between them as each point's gradient
/// says, blended by 6t⁵ − 15t⁴ + 10t³, so that second derivatives are continuous. Its mean over
/// seeds is 0 everywhere; in the middle of a cell its variance is 1/16. Its power lies around one
/// cycle in two units.
///                                [K. Perlin, "Improving noise", SIGGRAPH 2002; gradients of length
///                                √2 towards the middles of a cube's edges, here chosen by
///                                mix_bits]
/// @param p  in units of the lattice, each coordinate within ±2⁵².
/// @return  within ±1.04.   Cost: about 50 ns.
double gradient_noise(Vec3 p, std::uint64_t seed);

}  // namespace dewbow
