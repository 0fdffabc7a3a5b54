// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sunlight that has come straight through the clear atmosphere: what reddens a low sun, and a bow
// in its light.

#include "dewbow/base/quantity.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// A clear sky over a place near sea level.
struct ClearSky {
    double pressure_hPa = 1013.25;     ///< at the ground, 100 to 1100
    double aerosol_depth_500nm = 0.1;  ///< β, vertical optical depth of haze, 0 to 5
    double angstrom_exponent = 1.3;    ///< α of β (λ / 500 nm)^{−α}, −1 to 4
    double ozone_dobson = 300.0;       ///< 0 to 700
    // Haze of the continents, at 550 nm.       [Hess, Koepke & Schult, Bull. Am. Meteor. Soc. 79,
    // 831 (1998), Table 4: continental average]
    double aerosol_albedo = 0.925;     ///< share of its extinction that is scattered, 0 to 1
    double aerosol_asymmetry = 0.703;  ///< g of Henyey & Greenstein's phase function, 0 to 0.8
    double ground_albedo = 0.2;        ///< of a Lambertian ground, 0 to 1
    double eye_height_m = 2.0;         ///< from which the sky is seen, above the ground, 0 to 12000

    bool operator==(const ClearSky&) const = default;
};

/// Throws InputError, one sentence, for a value outside its range.
void validate(const ClearSky& sky);

/// The depth of haze at 500 nm that makes dark things vanish at a distance V on the ground:
/// 3.912 / V is the extinction at 550 nm of air and haze together.
///                                                             [Koschmieder 1924; 2 % contrast]
/// @param sky  its exponent and pressure count.
/// Throws InputError unless 1 km ≤ V and clean air sees as far (about 330 km), or where the depth
/// would be more than 5.
double aerosol_depth_from_visibility(Length visibility, const ClearSky& sky = {});
/// The inverse: V of a sky.
Length visibility_of(const ClearSky& sky);

/// Length of the path through air over that straight up, by the sun's apparent altitude h
/// (refraction included): 1 / (sin h + 0.50572 (h/° + 6.07995)^{−1.6364}); 37.9 on the horizon.
///                                             [Kasten & Young, Appl. Opt. 28, 4735 (1989), eq. 3]
/// @param altitude  0 to 90°; else InputError.
double relative_air_mass(Angle altitude);

/// The same for the ozone layer, thin at 22 km: (1 + 22/6370) / √(sin² h + 2 · 22/6370); 12.1 on
/// the horizon.                        [Robinson 1966; Bird & Riordan, J. Clim. Appl. Meteor. 25,
/// 87 (1986)]
double relative_ozone_mass(Angle altitude);

/// And for haze, which thins out exponentially by 1.5 km: over the sphere of air_column.h; 87.6 on
/// the horizon.
double relative_haze_mass(Angle altitude);

/// Vertical optical depths at sea level. Air: 0.008569 λ⁻⁴ (1 + 0.0113 λ⁻² + 0.00013 λ⁻⁴) with λ in
/// µm and 1013.25 hPa.                              [Hansen & Travis, Space Sci. Rev. 16, 527
/// (1974), eq. 2.30]
double rayleigh_depth(Wavelength lambda);
/// Of 300 Dobson units and in proportion: the Chappuis bands at 233 K in bins of 10 nm, 360 to 840
/// nm, linear between their middles.    [Gorshelev et al., Atmos. Meas. Tech. 7, 609 (2014),
/// averaged by E. Bruneton's precomputed_atmospheric_scattering]
double ozone_depth(Wavelength lambda, double dobson);

/// The share of sunlight that arrives in the direct beam, by wavelength:
/// exp(−m_air τ_Rayleigh − m_haze τ_aerosol − m_ozone τ_ozone).
///
/// Water vapour and oxygen are left out: against ASTM G173's direct beam (air mass 1.5) this is
/// within 1 % from 400 to 550 and from 670 to 780 nm, 3 % too bright in the weak bands at 570 to
/// 655 nm and 12 % at 830 nm.
/// @param altitude  of the sun, apparent, 0 to 90°.
/// Throws InputError: an altitude or a sky outside their ranges.
SpectrumPtr make_direct_transmittance(Angle altitude, const ClearSky& sky = {});

/// `above`, the light above the atmosphere, as it arrives.
SpectrumPtr make_direct_sunlight(SpectrumPtr above, Angle altitude, const ClearSky& sky = {});

}  // namespace dewbow
