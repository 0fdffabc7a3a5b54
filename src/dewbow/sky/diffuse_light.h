// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light in a clear atmosphere that has been scattered or reflected before: the field that air and
// haze scatter once more. Successive orders of scattering, in spherical harmonics.

#include <array>
#include <cmath>
#include <vector>

#include "dewbow/math/spherical_harmonics.h"
#include "dewbow/sky/air_optics.h"
#include "dewbow/sky/sight_line.h"

namespace dewbow {

/// Degree of the harmonics: with g = 0.7 what is left out of twice scattered light is 4e-4 of it.
inline constexpr int kDiffuseDegree = 16;
inline constexpr std::size_t kDiffuseHarmonics = harmonic_count(kDiffuseDegree);
/// Heights at which the field is known: kSkyTop_m (k / (n − 1))³.
inline constexpr int kDiffuseLevels = 36;
double diffuse_level_m(int k);

/// Coefficients of something by direction: Σ_m cos mφ Σ_l c_ml Λ_l^m(sin h), by altitude h and
/// azimuth φ from the sun.
using Harmonics = std::array<double, kDiffuseHarmonics>;

/// The sun, at azimuth 0.
struct SunPlace {
    explicit SunPlace(double altitude_rad)
        : altitude(altitude_rad), sine(std::sin(altitude)), cosine(std::cos(altitude)) {}
    double altitude;  ///< radians
    double sine, cosine;
};

/// The field at one wavelength, for an irradiance of 1 above the atmosphere. Of its radiance by
/// direction that one looks along, I = Σ_m I^m(sin h) cos mφ, it holds the moments
/// ½ ∫ Λ_l^m I^m d(sin h).
struct DiffuseField {
    std::vector<Harmonics> moments;  ///< by level
    double ground_irradiance = 0.0;  ///< scattered light that falls on the ground
    int orders = 0;                  ///< that were added

    /// Moments at a height, linear in its cube root between levels.
    Harmonics at(double height_m) const;
};

/// Moments of sunlight alone, by level: it comes there along its true path over a sphere.
/// @param sun  also a little below the horizon.   @param masses  made for a sun within 9° of it.
std::vector<Harmonics> beam_moments(const AirOptics& optics, const SunPlace& sun,
                                    const SunMasses& masses);

/// The field under a beam, by successive orders in level air. 12 Gaussian directions a hemisphere;
/// sources are linear in depth between levels; orders are added until one is below 1 % of their
/// sum, and the rest as a geometric series (error 1e-4).
/// @param onto_ground  what the beam brings to level ground.   @param slope  how beam and field
/// change with the sun's altitude, per radian, or empty: light from places where the sun is higher
/// or lower is then put right to first order.
DiffuseField diffuse_field(const AirOptics& optics, double asymmetry, double ground_albedo,
                           const std::vector<Harmonics>& beam, double onto_ground,
                           const std::vector<Harmonics>& slope = {});

/// What turns moments into the harmonics of light scattered towards the eye, per optical depth of
/// scattering: (2l + 1) χ_l for l from 0 to kDiffuseDegree, with χ_l the phase function's moments.
using PhaseMoments = std::array<double, kDiffuseDegree + 1>;
PhaseMoments air_phase_moments();
PhaseMoments haze_phase_moments(double asymmetry);

}  // namespace dewbow
