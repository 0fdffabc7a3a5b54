// SPDX-License-Identifier: Apache-2.0
#pragma once

// The albedo layer: the colour of surfaces themselves, for denoisers and compositors.

#include "dewbow/render/surface_inputs.h"
#include "dewbow/spectrum/colour.h"

namespace dewbow {

/// Colour of the surface of each material of `scene` under D65, white = (1, 1, 1) in linear sRGB:
/// its diffuse reflectance or base colour, a metal's reflectance at normal incidence; glass is
/// white. Of what varies, the colour without texture.
std::vector<Colour<Xyz>> albedo_of_materials(const Scene& scene);

/// That of one place, where the colour of `material` comes from a texture or from the vertices.
Colour<Xyz> albedo_at(const Material& material, Colour<Xyz> otherwise,
                      const SurfaceCoordinates& at);

}  // namespace dewbow
