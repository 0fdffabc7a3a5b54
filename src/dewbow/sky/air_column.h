// SPDX-License-Identifier: Apache-2.0
#pragma once

// How air, haze and ozone lie above each other, and how much of each a ray crosses on its way out.
// Densities are shares of the vertical column per metre, so that a column is a relative air mass.

#include <algorithm>

namespace dewbow {

/// Radius of a sphere over which light bent by air runs straight: R / (1 − k), with R = 6371 km
/// and Gauss's coefficient of terrestrial refraction, k = 0.13. With it directions are apparent
/// ones, as a camera sees them; the horizon's air mass is that of Kasten & Young to 1 %.
inline constexpr double kSkyRadius_m = 6371e3 / (1.0 - 0.13);
/// Above it there is nothing: 1e-5 of the air's column is.
inline constexpr double kSkyTop_m = 75e3;
/// Haze thins out exponentially: 1.5 km makes depth 0.235 of a visibility of 23 km, as in 6S.
inline constexpr double kHazeScale_m = 1500.0;

/// What each kind of matter holds, in some unit that the function says.
struct AirParts {
    double air = 0.0, haze = 0.0, ozone = 0.0;

    friend AirParts operator+(AirParts a, AirParts b) {
        return {a.air + b.air, a.haze + b.haze, a.ozone + b.ozone};
    }
    friend AirParts operator*(double s, AirParts a) { return {s * a.air, s * a.haze, s * a.ozone}; }
    /// Optical depth, or extinction: amounts times what one unit of each does.
    friend double dot(AirParts a, AirParts b) {
        return a.air * b.air + a.haze * b.haze + a.ozone * b.ozone;
    }
};

/// Share of the vertical column per metre at a height above the ground; below it as on it.
/// Air: the U.S. Standard Atmosphere 1976 to 20 km, isothermal above. Haze: exponential. Ozone: a
/// hump 1 + cos from 7 to 37 km about 22 km, the height of direct_sun.h.
/// @param height_m  to kSkyTop_m; above it the formulas go on.
AirParts air_density(double height_m);

/// Relative masses of the way from a height out of the air.
/// @param height_m  0 to kSkyTop_m.   @param sin_altitude  sine of the direction's angle above the
/// local level, −1 to 1. Where the sphere is in the way the ray goes through it, in air as dense as
/// that on the ground: a large number, continuous at the horizon.
/// Error against a fine quadrature: 1e-3.
AirParts air_mass_to_space(double height_m, double sin_altitude);

/// Share of the sun's disc above the sphere's edge, as seen from a height; smooth
/// over the disc.   @param sin_altitude  of its centre.
double visible_share_of_sun(double height_m, double sin_altitude);

}  // namespace dewbow
