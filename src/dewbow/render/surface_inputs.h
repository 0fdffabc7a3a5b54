// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a material's inputs are at one place of a surface.

#include <array>

#include "dewbow/render/rgb_lanes.h"
#include "dewbow/scene/surface_input.h"

namespace dewbow {

/// What textures are looked up by.
struct SurfaceCoordinates {
    std::array<TexturePoint, 2> uv;              ///< both sets of the mesh
    Colour<LinearSrgb> colour{{1.0, 1.0, 1.0}};  ///< of the mesh's vertices
};

class SurfaceInputs {
public:
    /// Both outlive this.
    SurfaceInputs(const SurfaceCoordinates& at, RgbReflectanceLanes& rgb) : at_(at), rgb_(rgb) {}

    double number(const NumberInput& input) const;
    /// At each lane; 1 for an empty input.
    void colour(const ColourInput& input, const LaneSet& lanes, LaneValues& out) const;

private:
    const SurfaceCoordinates& at_;
    RgbReflectanceLanes& rgb_;
};

}  // namespace dewbow
