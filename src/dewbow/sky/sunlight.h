// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sun and moon as they shine on the top of the atmosphere.

#include "dewbow/rainbow/sun_disc.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// Mean radius of the moon's disc in the sky; the sun's is kSunRadius.
///                                [Astronomical Almanac: 932.6″ at 384 400 km]
inline constexpr Angle kMoonRadius = 0.25905 * unit::deg;

/// Spectral irradiance of the sun above the atmosphere, W m⁻² nm⁻¹: 133 300 lx at 1 au.
///                                                                        [ASTM E490-00a]
/// @param distance_au  of the sun: 0.983 to 1.017 in the course of a year.
SpectrumPtr make_sunlight_above(double distance_au = 1.0);

/// Spectral irradiance of the moon above the atmosphere, W m⁻² nm⁻¹: sunlight times the disc's
/// reflectance of the US Geological Survey's observations, of waxing and waning moon alike, smooth
/// over wavelength; moon and sun at their mean distances.
///                          [Kieffer & Stone, Astron. J. 129, 2887 (2005), eq. 8, 10 and Table 4]
/// @param phase  between sun and Earth as seen from the moon: 0° full moon, 90° half; 0 to 97°, the
/// range of the observations, else InputError. Below 1.55° the moon goes into the Earth's shadow;
/// what is seen of it before is held.
SpectrumPtr make_moonlight_above(Angle phase);

}  // namespace dewbow
