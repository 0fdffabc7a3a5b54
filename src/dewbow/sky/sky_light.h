// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sunlight scattered towards an eye, for the knots of a SkyTable.

#include <array>
#include <vector>

#include "dewbow/math/vector.h"
#include "dewbow/sky/air_optics.h"
#include "dewbow/sky/diffuse_light.h"
#include "dewbow/sky/sight_line.h"
#include "dewbow/sky/sky_table.h"

namespace dewbow {

/// A clear day at kSkyWavelengths: its air, its sun, and what has been scattered before.
struct ClearDay {
    /// Throws nothing; `sky` has been validated.
    ClearDay(const ClearSky& sky, const SunPlace& sun);

    double asymmetry;
    SunPlace sun;
    SunMasses masses;
    std::array<AirOptics, kSkyWavelengths> optics;
    std::vector<DiffuseField> diffuse;
    /// How diffuse changes with the sun's altitude, per radian: places that are seen far away
    /// towards the sun have a higher one.
    std::vector<DiffuseField> diffuse_slope;
    /// What the ground sends back, over the sun's irradiance, sr⁻¹.
    std::array<double, kSkyWavelengths> ground;

private:
    void solve(const ClearSky& sky, int k);
};

/// The azimuth of a direction from the sun, radians, 0 to π.
double azimuth_from(Dir<World> to_sun, Dir<World> direction);

/// The sky as seen from a height, and the ground below its horizon through the air before it.
enum class SkyHalf { above, below };
/// From the horizon straight up, or down, radians.
double reach_of(SkyHalf half, double eye_m);

/// Radiance over the sun's irradiance above the atmosphere, sr⁻¹, [angle][azimuth][wavelength].
std::vector<double> sky_light(const ClearDay& day, SkyHalf half, double eye_m);

}  // namespace dewbow
