// SPDX-License-Identifier: Apache-2.0
#pragma once

// How wrong the sum of orders (Composition) is, by size and angle, and where it is not good enough.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Drops with smaller x are always left to Mie theory: it costs little, and the sum of orders is
/// wrong by more than 10 %.
inline constexpr double kLeastSummedSize = 200.0;
/// Light of different orders differs in path by several radii. Where the standard deviation of x
/// is above this, averages over sizes leave less than 1e-3 of its interference.
inline constexpr double kWashedOutDeviation = 4.0;
/// Whether drops of index n + ik absorb so little, 8 k x of the light of an order at most, that
/// the sum of orders may forget it.
constexpr bool is_clear(double k, double x) { return k * x < 2e-4; }
/// Whether a disc is too small to count.
inline bool is_point(Angle disc_radius) { return disc_radius < 0.2 * unit::deg; }

/// A range of scattering angles.
struct AngleRange {
    Angle from, to;
};

/// Of Composition against Mie in these angles, |ΔI| over the larger of I and the primary bow's
/// peak: max(per_size · 1000 / x, least).
struct RegionError {
    AngleRange range;
    double per_size, least;
};
/// From 0° to 180°. Point: for a point source; otherwise for discs of the sun's size or larger.
std::span<const RegionError> composition_errors(bool point);

/// What of the sphere Composition gets right to within a tolerance, and what not.
struct AutomaticPlan {
    std::vector<AngleRange> exact;  ///< where Mie is needed, ascending
    double error = 0.0;             ///< the largest elsewhere
};
/// @param x  effective size parameter of the drops, Σ x³ / Σ x².
AutomaticPlan plan_angles(double x, bool point, double tolerance);

/// How much the exact value counts at an angle: 1 within the ranges, falling to 0 over
/// kBlend beyond.
double exact_weight(std::span<const AngleRange> exact, Angle theta);
inline constexpr Angle kBlend = 3.0 * unit::deg;

}  // namespace dewbow
