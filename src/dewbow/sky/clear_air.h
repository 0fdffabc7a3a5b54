// SPDX-License-Identifier: Apache-2.0
#pragma once

// The air of a clear sky as aerial perspective.

#include "dewbow/sky/aerial.h"
#include "dewbow/sky/sky_light.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// @param to_sun  unit, in the world.   @param above  the sun's irradiance above the atmosphere.
AerialPtr make_clear_air(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun,
                         SpectrumPtr above);

}  // namespace dewbow
