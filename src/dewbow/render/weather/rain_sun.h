// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "dewbow/math/vector.h"
#include "dewbow/render/weather/mirrored_sun.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// A light infinitely far and small, by which rain shows bows.
struct RainSun {
    Vec3 towards;                    ///< unit, to its middle
    SpectrumPtr irradiance;          ///< on a surface that faces it, W m⁻² nm⁻¹
    int light;                       ///< among LightSet::infinite()
    std::vector<std::size_t> discs;  ///< what it is to the drops of each rain: DropCloud::discs()
    std::optional<MirroredSun> mirror{};  ///< by which `towards` is an image of it, if it is one
};

}  // namespace dewbow
