// SPDX-License-Identifier: Apache-2.0
#pragma once

// A sky wholly covered by cloud.

#include "dewbow/base/quantity.h"
#include "dewbow/sky/sky_dome.h"

namespace dewbow {

/// Light on level ground under an even layer of cloud: 300 lx + 21 000 lx sin h, h the sun's
/// altitude.              [Krochmann & Seidl, Lighting Res. & Technol. 6, 165 (1974)]
/// @param sun_altitude  0 to 90°, else InputError.
double overcast_illuminance_lx(Angle sun_altitude);

/// The CIE's overcast sky: L(γ) = L_z (1 + 2 sin γ) / 3 at the altitude γ, three times as bright
/// overhead as at the horizon; white as D65. E = 7π/9 L_z.
///                                 [Moon & Spencer 1942; ISO 15469:2004/CIE S 011, type 16]
/// Below the horizon: the ground, Lambertian.
/// @param ground_albedo  0 to 1, else InputError.
SkyDomePtr make_overcast_dome(Angle sun_altitude, double ground_albedo = 0.2);

}  // namespace dewbow
