// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light in a clear atmosphere that has been scattered or reflected before: the field that air and
// haze scatter once more. Successive orders of scattering, in spherical harmonics.

#include <array>
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
    double altitude;  ///< radians, 0 to π/2
    double sine, cosine;
};

/// The field at one wavelength, for an irradiance of 1 above the atmosphere.
///
/// The air is level and even; sunlight alone comes to each level along its true path over a sphere.
/// Radiance by direction that one looks along: I(h, φ); a moment is ½ ∫ Λ_l^m I^m d(sin h), of
/// I = Σ_m I^m cos mφ, by 12 Gaussian nodes a hemisphere. Orders are added until one is below 1e-4
/// of their sum.
class DiffuseLight {
public:
    DiffuseLight(const AirOptics& optics, double asymmetry, double ground_albedo,
                 const SunPlace& sun, const SunMasses& masses);

    /// Moments at a height, linear in its cube root between levels.
    Harmonics moments_at(double height_m) const;
    /// Downward flux of scattered light on the ground.
    double ground_irradiance() const { return ground_irradiance_; }
    int orders() const { return orders_; }

private:
    std::vector<Harmonics> moments_;  ///< by level
    double ground_irradiance_ = 0.0;
    int orders_ = 0;
};

/// What air makes of moments: harmonics of light scattered towards the eye per optical depth of
/// scattering, sr⁻¹. Only l = 0 and 2 are not 0.
/// (2l + 1) χ_l of each l from 0 to kDiffuseDegree, χ_l the phase function's moments.
using PhaseMoments = std::array<double, kDiffuseDegree + 1>;
PhaseMoments air_phase_moments();
PhaseMoments haze_phase_moments(double asymmetry);

}  // namespace dewbow
