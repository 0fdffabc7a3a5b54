// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drops in fewer classes, and what the classes are together.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/cloud_scattering.h"

namespace dewbow {

/// Classes in about `most` groups, ⟨1⟩ and ⟨r²⟩ kept in each.
/// @param offset  0 to 1: where the groups begin, in groups.
std::vector<WeightedRadius> grouped(std::span<const WeightedRadius> radii, std::size_t most,
                                    double offset = 0.0);

struct SizeMoments {
    Length effective;  ///< Σ r³ / Σ r²
    Length deviation;  ///< standard deviation of r, weighted by r²
};
SizeMoments moments_of(std::span<const WeightedRadius> radii);

/// Radii that Mie theory needs so that interference between light of different orders averages
/// out: orders differ in path by up to five radii, so steps of 0.7 in x.
std::size_t radii_needed(const Cloud& cloud, Wavelength lambda);

/// Σ share x².
double mean_x_squared(const Cloud& cloud, Wavelength lambda);

}  // namespace dewbow
