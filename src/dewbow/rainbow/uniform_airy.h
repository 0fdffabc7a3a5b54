// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model `uniform_airy`: bows from the two rays beside them, joined by Airy functions so that
// the sum holds at the bow and far from it (uniform_bow.h; docs/rainbow-models.md).

#include <memory>

#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/models.h"

namespace dewbow {

/// An AmplitudeModel of drops of real index 1.30 to 1.36, x from 10 to 50,000. Orders 2 to 7,
/// summed with their phases; none asked for: all of these. NaN nearer to 0° and 180° than 4/x where
/// light that does not run along the axis meets there (p >= 4).
/// Throws InputError for orders that it does not have.
std::unique_ptr<ScatteringModel> make_uniform_airy(const ModelOptions& options);

/// How wrong it is, against the Debye series: root mean square of the error of |S_1|² + |S_2|² over
/// the greatest value of the same order, on the main bow (from 2 Airy units on the dark side to 1.9
/// on the bright one) and on the fringes up to 8 units.
struct BowError {
    double main_bow, fringes;
};
/// An upper bound where it is below 20 %, measured for n = 1.30 to 1.36, p = 2 to 7 and x = 300 to
/// 20,000 (LongUniformAiry): 1 to 4 times the error. Both depend on x cos³i of the Descartes ray
/// only: how far it is from the edge, in widths of the edge's diffraction.
BowError uniform_airy_error(RelativeIndex n, int p, double size_parameter);

}  // namespace dewbow
