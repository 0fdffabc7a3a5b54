// SPDX-License-Identifier: Apache-2.0
#pragma once

// Spectra for the colours of pictures, at the lanes of a packet: fast enough for every hit.

#include "dewbow/render/lanes.h"
#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// Seven smooth spectra — white, cyan, magenta, yellow, red, green, blue — of which every colour is
/// a mixture of at most three with weights >= 0. What is linear in the spectrum is exact: the
/// mixture's XYZ are the colour's, and a filtered texel has the filtered spectrum.
/// [after Smits, "An RGB to Spectrum Conversion for Reflectances", 1999]
using RgbBasis = std::array<SpectrumPtr, 7>;

/// Of light: (1, 1, 1) is D65, as bright as the constant spectrum 1.
const RgbBasis& light_basis();
/// Of reflectances: (1, 1, 1) is exactly 1; none exceeds 1, and so no mixture does.
const RgbBasis& reflectance_basis();

class RgbLanes {
public:
    explicit RgbLanes(const RgbBasis& basis) : basis_(basis) {}
    /// Forgets everything: a new packet begins.
    void begin(const WavelengthPacket& packet) { packet_ = &packet, ready_ = false; }
    /// The spectrum of `rgb` (no negative channel) at each lane.
    void eval(Colour<LinearSrgb> rgb, const LaneSet& lanes, LaneValues& out);

private:
    const RgbBasis& basis_;
    const WavelengthPacket* packet_ = nullptr;
    bool ready_ = false;
    std::array<LaneValues, 7> values_;
};

struct RgbLightLanes : RgbLanes {
    explicit RgbLightLanes(const RgbBasis& basis = light_basis()) : RgbLanes(basis) {}
};
struct RgbReflectanceLanes : RgbLanes {
    explicit RgbReflectanceLanes(const RgbBasis& basis = reflectance_basis()) : RgbLanes(basis) {}
};

}  // namespace dewbow
