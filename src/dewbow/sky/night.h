// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is left of light at night when there is no moon.

#include "dewbow/sky/direct_sun.h"
#include "dewbow/sky/sky_dome.h"

namespace dewbow {

/// Airglow, light of stars and zodiacal light far from towns, 1.9e-4 cd m⁻² overhead (21.9
/// magnitudes per square second of arc), evened out over all azimuths: single stars are not shown.
///
/// Airglow overhead: 250 R at 557.7 nm, 50 R at 589.3 nm, 100 R at 630.0 nm (with 33 R at 636.4)
/// and 3 R nm⁻¹ between, the lines 20 nm wide; 1 R = 10¹⁰/4π photons m⁻² s⁻¹ sr⁻¹. The rest has the
/// sun's colour, 75 stars of magnitude 10 a square degree.
///                 [Leinert et al., Astron. Astrophys. Suppl. 127, 1 (1998), §6 and Table 13;
///                                      Roach & Gordon, The Light of the Night Sky (1973)]
/// Towards the horizon airglow grows as X = 1 / √(1 − 0.96 sin² z), and the air's depth τ(λ) takes
/// e^{−τ (X − 1)} from all of it.       [Garstang, Publ. Astron. Soc. Pacific 101, 306 (1989)]
/// @param air  of its depth and of the ground's albedo. Throws InputError for one outside its
/// ranges.
SkyDomePtr make_moonless_dome(const ClearSky& air = {});

}  // namespace dewbow
