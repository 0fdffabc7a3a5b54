// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scattering angles at which to compute, so that straight lines between them are right: close
// together at the bows and towards 0° and 180°, far apart elsewhere.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

/// What the angles are for.
struct AngleGrid {
    RelativeIndex least, greatest;  ///< of the drops, over all wavelengths
    double x = 0.0;  ///< of the drops, Σ x³ / Σ x²; of the largest if it has a range
    /// Whether interference between orders is seen, as with drops of one size: then the steps are
    /// half of its fringes everywhere.
    bool fringes = false;
    Angle from = 0.0 * unit::deg, to = 180.0 * unit::deg;
    Angle longest = 0.4 * unit::deg;  ///< step
    /// Parts of an Airy unit (h/x²)^{1/3} between angles at the bows.
    double parts = 12.0;
};

/// Ascending, `from` and `to` among them.
///
/// Error of straight lines between them, for drops that differ in size by 10 %: 0.3 % of the larger
/// of the value and the primary's peak with 12 parts (angle_grid_test.cpp), and as the square of
/// the steps.
std::vector<Angle> adaptive_angles(const AngleGrid& grid);

/// Both together, ascending, each angle once.
std::vector<Angle> merged_angles(std::span<const Angle> a, std::span<const Angle> b);

}  // namespace dewbow
