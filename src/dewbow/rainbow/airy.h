// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model `airy`: Airy's bow, for each polarisation, absolute.
//
// Around the Descartes ray's angle θ_R, with h = ½ d²D/db² and ε_j = (1 - r_j²)(-r_j)^{p-1} there,
//
//   |S_j|² = 2π x^{7/3} b / (sin θ_R h^{2/3}) [ε_j² Ai²(-z) + (dε_j/db)² (xh)^{-2/3} Ai'²(-z)],
//   z = ±(θ - θ_R) (x²/h)^{1/3}, positive on the bright side.
//   [Airy 1838; van de Hulst 1957, §13.2; Können & de Boer 1979, Appl. Opt. 18, 1961: Ai']

#include <memory>

#include "dewbow/rainbow/models.h"

namespace dewbow {

/// An AmplitudeModel of drops of real index between 1 and the order, x from 10 to 50,000.
/// Orders 2 to 7, summed with their phases; none asked for: 2 and 3. NaN beyond two_ray_region()
/// of any of them. Of the p = 2 peak at n = 1.333 it is wrong by 2 % at x = 1000 and 0.6 % at 5000,
/// further inside by much more (see docs/rainbow-models.md).
/// Throws InputError for orders that it does not have.
std::unique_ptr<ScatteringModel> make_airy(const ModelOptions& options);

}  // namespace dewbow
