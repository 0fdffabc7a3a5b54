// SPDX-License-Identifier: Apache-2.0
#pragma once

// Grows the tree of a density from observations, so that what is estimated with samples of it has
// little variance.
//
// An estimate ∑ f/p of an integral has the variance ∫ f²/p − (∫ f)². Among the densities that are
// constant in given boxes the best holds in each the share √(V ∫ f²) of its volume V and its ∫ f²
// (Cauchy–Schwarz); so boxes are cut where the sum of these roots falls most.   [Rath et al.,
// "Variance-Aware Path Guiding", 2020, section 4.1, for a density in boxes]

#include <span>

#include "dewbow/render/caustics/learnt_density.h"

namespace dewbow::caustics {

struct DensityObservation {
    AimPoint at;
    /// f² over the density that `at` was sampled with, in any unit, > 0. Integers: sums of them do
    /// not depend on the order.
    std::uint32_t weight;
};

/// @param observations  fewer than 2³¹; their order may be changed.
/// @param light_edges  where along the first coordinate one light ends and the next begins,
/// ascending: there alone it is cut. Other coordinates are cut in halves.
LearntDensity fit_density(std::span<DensityObservation> observations,
                          std::span<const double> light_edges);

}  // namespace dewbow::caustics
