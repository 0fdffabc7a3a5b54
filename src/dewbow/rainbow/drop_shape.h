// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drops that are not spheres: falling raindrops are flattened, the more the larger they are, and
// turn the light of each bow by another angle. The primary bow of large drops is smaller at its
// top, the secondary is not: where large and small drops fall together, the primary is twinned.

#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Height over width of a raindrop that falls in calm air, by the radius of the sphere of equal
/// volume: 1.0048 + 5.7e-4 D − 2.628e-2 D² + 3.682e-3 D³ − 1.677e-4 D⁴ with the diameter D in mm,
/// up to 6 mm; 1 for small drops (below 0.44 mm across, where the fit exceeds it).
///          [Beard & Chuang, J. Atmos. Sci. 44, 1509 (1987), as in Kalogiros et al., IEEE TGRS
///          2013, eq. 4]
double raindrop_axis_ratio(Length radius);

/// A drop of this shape.
struct Spheroid {
    double axis_ratio = 1.0;  ///< along the axis over across, 0.5 to 1.5
    /// Of the axis against the vertical: towards the sun's azimuth, and to the right of that.
    Angle tilt_to_sun{}, tilt_to_right{};
};

/// Where on the bow: the sun's altitude, −90° to 90°, and the clock angle from the bow's top around
/// the antisolar point (around the sun, for the bows of order 4 and 5).
struct BowPlace {
    Angle sun_altitude{}, clock{};
};

/// By how much the bows of order 2 to 7 are turned towards larger scattering angles, by rays
/// through the spheroid: the extremum of the deflection among all rays that leave with that clock
/// angle. Zero for spheres, and for orders 0 and 1.
///
/// Error 1e-7 rad for shifts below 5°. Where there is no fold of light near the sphere's (axis
/// ratios below about 0.85) it is what first_order_bow_shifts says. Cost: about 10 µs an order.
BowShifts bow_shifts(RelativeIndex n, const Spheroid& shape, const BowPlace& place);

/// The same to first order in e = (1 − axis ratio) / (1 + axis ratio), for a drop without tilt:
/// ΔD = −e A_p V cos(ρ − 2α), V = sin²h + cos²h cos²χ, sin α = sin h / √V, ρ = 180° − the bow's
/// scattering angle; for p = 2 at the top with the sun on the horizon, Möbius's 16 e sin r cos³ r.
///                     [Möbius, Ann. Phys. 33, 1493 (1910); Können, J. Opt. Soc. Am. A 4, 810
///                     (1987)]
/// Error for the top of the bow, p = 2: 1 % at 0.75 mm across, 3 % at 1 mm, 12 % at 2 mm.
BowShifts first_order_bow_shifts(RelativeIndex n, double axis_ratio, const BowPlace& place);

/// A_p = 2(p−1)(tan r cos pu + 2 sin pu) − 2 tan r Σ_j cos((2j−p)u) + 4 Σ_j (2j−p) sin((2j−p)u),
/// with u = π − 2r, r the refraction of the Descartes ray, j = 1 … p−1: change of the deflection
/// per e in the plane of the axes, as cos 2ψ. For p = 2 it is −16 sin r cos³ r.
double oblateness_amplitude(RelativeIndex n, int p);

/// How drops of one size differ from each other.
struct ShapeSpread {
    double oscillation = 0.0;  ///< standard deviation of e over e, 0 to 1
    Angle tilt{};  ///< standard deviation of the axis in each of two directions, 0 to 30°
};
struct WeightedShape {
    Spheroid shape;
    double share = 0.0;
};
/// Raindrops of one size: a single shape without spread; else three for each kind of it (Gauss's
/// rule for a normal distribution: exact for means of polynomials up to the fifth degree). Shares
/// sum to 1. Throws InputError for a spread outside its range.
std::vector<WeightedShape> raindrop_shapes(Length radius, const ShapeSpread& spread);

}  // namespace dewbow
