// SPDX-License-Identifier: Apache-2.0
#pragma once

// The clear sky of a day: sunlight scattered by air and haze, any number of times, thinned by
// ozone and lit from below by the ground. One table for each condition and height of the sun.

#include <memory>

#include "dewbow/sky/aerial.h"
#include "dewbow/sky/direct_sun.h"
#include "dewbow/sky/sky_dome.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// The sky over level ground at sea level, without the sun's disc, seen from
/// ClearSky::eye_height_m. Below the horizon (which lies the lower the higher the eye is): the
/// ground, Lambertian, in the light of sun and sky, through the air before it.
class ClearSkyDome : public SkyDome {
public:
    /// The same sky's air between things.
    virtual AerialPtr aerial() const = 0;
    /// Light of the sky alone on level ground, W m⁻² nm⁻¹.
    virtual SpectrumPtr diffuse_irradiance() const = 0;
};
using ClearSkyDomePtr = std::shared_ptr<const ClearSkyDome>;

/// Computes the tables.
/// @param to_sun  apparent direction of the sun's centre, unit, on or above the horizon.
/// @param above_atmosphere  the sun's spectral irradiance above the atmosphere, W m⁻² nm⁻¹. It is
/// multiplied in at full resolution; only its ratio to the sky's light is interpolated.
/// Throws InputError: a sky outside its ranges, a sun below the horizon.
ClearSkyDomePtr make_clear_sky_dome(const ClearSky& sky, Dir<World> to_sun,
                                    SpectrumPtr above_atmosphere);

}  // namespace dewbow
