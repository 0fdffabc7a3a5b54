// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sunlight scattered towards an eye on the ground, for the knots of a SkyTable.

#include <array>
#include <vector>

#include "dewbow/sky/air_optics.h"
#include "dewbow/sky/sight_line.h"
#include "dewbow/sky/sky_table.h"

namespace dewbow {

/// The air at the wavelengths of a sky.
using SkyOptics = std::array<AirOptics, kSkyWavelengths>;
SkyOptics sky_optics(const ClearSky& sky);

/// The sun, at azimuth 0.
struct SunPlace {
    double altitude;  ///< radians, 0 to π/2
    double sine, cosine;
};

/// Radiance over the sun's irradiance above the atmosphere, sr⁻¹:
/// [elevation][azimuth][wavelength].
std::vector<double> sky_light(const ClearSky& sky, const SunPlace& sun);

}  // namespace dewbow
