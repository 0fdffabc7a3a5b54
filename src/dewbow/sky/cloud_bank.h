// SPDX-License-Identifier: Apache-2.0
#pragma once

// A bank of dark cloud before a part of another sky: what a bow is seen against.

#include "dewbow/base/quantity.h"
#include "dewbow/sky/sky_dome.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// Where a bank of cloud hides the sky behind it, and how bright it is itself. Its edges run along
/// azimuths and altitudes, and are soft and ragged.
struct CloudBank {
    Angle azimuth;                      ///< of its middle, from north clockwise
    Angle width = 180.0 * unit::deg;    ///< from edge to edge, > 0, to 360° (all around)
    Angle bottom = -90.0 * unit::deg;   ///< altitude of its lower edge; −90°: there is none
    Angle top = 90.0 * unit::deg;       ///< of its upper edge, above the lower; 90°: there is none
    Angle softness = 10.0 * unit::deg;  ///< width of each edge, centred on it, 0 to 60°
    double luminance_share = 0.3;       ///< of the mean luminance of the sky behind, 0 to 2
    double cover = 1.0;                 ///< share of what is behind that it hides, 0 to 1
    /// How much its luminance differs from place to place, and how ragged its edges are: 0 even, 1
    /// from nothing to twice the mean.
    double texture = 0.5;
    std::uint64_t seed = 0;           ///< another one is another cloud
    Angle horizon = 0.0 * unit::deg;  ///< altitude above which there is sky; a high eye's is lower
};

/// Throws InputError, one sentence, for a value outside its range.
void validate(const CloudBank& cloud);

/// Share of the light from `direction` that the bank hides, 0 to `cover`; none below its horizon.
double cover_towards(const CloudBank& cloud, Dir<World> direction);

/// `behind` with the bank before it. The bank has the luminance share · E / π, E the illuminance of
/// `behind` on level ground, and the colour of `light`.
/// @param light  a spectrum of any size, not black: sunlight and skylight together are grey by day
/// and red at sunset. What `behind` says of the ground is kept.
SkyDomePtr make_cloud_bank_dome(SkyDomePtr behind, const CloudBank& cloud, SpectrumPtr light);

/// The sum of two skies, both there at once: scattered moonlight and the light of the night.
SkyDomePtr make_sum_of_domes(SkyDomePtr a, SkyDomePtr b);

/// ∫ L sin h dω over the upper half of a sky, lx, by 64 × 256 midpoints.
double illuminance_lx(const SkyDome& sky);

}  // namespace dewbow
