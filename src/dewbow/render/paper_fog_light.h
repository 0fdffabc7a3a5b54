// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's rainbow at the lanes of a packet: what its fog replaces of the light along a ray, and
// by what.

#include "dewbow/render/rgb_lanes.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// What stands on a flight; of light L behind it L (1 − replaced) + light is left.
struct FogVeil {
    LaneValues replaced, light;  ///< a share; W m⁻² sr⁻¹ nm⁻¹
};

class PaperFogLight {
public:
    /// @param scene  with a paper_rainbow, and with a sun.
    explicit PaperFogLight(const Scene& scene);

    const PaperFog& fog() const { return fog_; }
    /// Of white fog, over that of the constant spectrum 1.
    double white() const { return white_; }

    /// False where there is no fog. Exact in colour where the fog is white or its channels replace
    /// alike, as in both of the paper's rainbows.
    /// @param direction  of the ray, from the eye, unit length.   @param distance  m, to what it
    /// meets; may be infinite.   @param u  in [0, 1)².   @param shares, colours  what colours are
    /// at the packet's wavelengths.
    bool on_ray(Vec3 direction, double distance, std::array<double, 2> u, const LaneSet& lanes,
                RgbReflectanceLanes& shares, RgbLightLanes& colours, FogVeil& veil) const;

private:
    PaperFog fog_;
    double white_;
};

}  // namespace dewbow
