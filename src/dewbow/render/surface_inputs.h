// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a material's inputs are at one place of a surface.

#include <array>

#include "dewbow/render/rgb_lanes.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// What textures are looked up by.
struct SurfaceCoordinates {
    std::array<TexturePoint, 2> uv;              ///< both sets of the mesh
    Colour<LinearSrgb> colour{{1.0, 1.0, 1.0}};  ///< of the mesh's vertices
    double alpha = 1.0;                          ///< of the mesh's vertices
};

/// On `triangle` of `mesh`, with weights `u`, `v` of its vertices 1 and 2. Where the mesh has only
/// one set of texture coordinates it stands for both, where it has none they are 0.
SurfaceCoordinates coordinates_on(const Mesh& mesh, int triangle, double u, double v);
/// On a shape that has coordinates of its own.
SurfaceCoordinates coordinates_on_chart(double u, double v);

/// Whether what the surface does to light differs from place to place; of a mix, any part of it.
bool surface_varies(const Scene& scene, const Material& material);

/// The colour that an input which varies has at one place, each channel within 0 to 1.
Colour<LinearSrgb> colour_at(const ColourInput& input, const SurfaceCoordinates& at);
/// `input` at one place.
double number_at(const NumberInput& input, const SurfaceCoordinates& at);

class SurfaceInputs {
public:
    /// Both outlive this.
    SurfaceInputs(const SurfaceCoordinates& at, RgbReflectanceLanes& rgb) : at_(at), rgb_(rgb) {}

    double number(const NumberInput& input) const { return number_at(input, at_); }
    /// At each lane; 1 for an empty input.
    void colour(const ColourInput& input, const LaneSet& lanes, LaneValues& out) const;

private:
    const SurfaceCoordinates& at_;
    RgbReflectanceLanes& rgb_;
};

}  // namespace dewbow
