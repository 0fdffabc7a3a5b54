// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a clear sky's air does to light of one wavelength.

#include "dewbow/sky/air_column.h"
#include "dewbow/sky/direct_sun.h"

namespace dewbow {

struct AirOptics {
    AirParts depth;                ///< vertical optical depth of each part
    double haze_scattering = 0.0;  ///< of it, what haze scatters; air scatters all, ozone none
};

AirOptics air_optics(const ClearSky& sky, Wavelength lambda);

/// Depolarisation factor of air, ρ = 0.0279, as γ = ρ / (2 − ρ).             [Young 1980; Bucholtz,
/// Appl. Opt. 34, 2765 (1995)]
inline constexpr double kAirAnisotropy = 0.0279 / (2.0 - 0.0279);

/// Rayleigh's phase function with anisotropic molecules, sr⁻¹; its integral over the sphere is 1:
/// 3 (1 + 3γ + (1 − γ) cos² θ) / (16 π (1 + 2γ)).                           [Chandrasekhar 1950;
/// Bucholtz 1995, eq. 12]
/// @param cosine  of the scattering angle, 1 forward.
double air_phase(double cosine);

/// Henyey & Greenstein's: (1 − g²) / (4π (1 + g² − 2 g cos θ)^{3/2}), sr⁻¹.
double haze_phase(double cosine, double asymmetry);

}  // namespace dewbow
