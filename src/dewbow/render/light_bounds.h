// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is known of a light, or of many together, without looking at each: where it is, how brightly
// it shines at most, and into which directions.

#include "dewbow/scene/scene.h"

namespace dewbow {

/// The directions within `half_angle_rad` of `axis`.
struct DirectionCone {
    Vec3 axis{0.0, 0.0, 1.0};  ///< unit
    double half_angle_rad = 0.0;

    static DirectionCone all();
};
/// A cone that holds both.
DirectionCone join(const DirectionCone& a, const DirectionCone& b);

/// [Conty Estevez & Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018,
/// section 4]
struct LightBounds {
    Bounds box;
    /// Brightness of the intensity (Y of W sr⁻¹ nm⁻¹, white 1) in its brightest direction; of
    /// several lights the sum. 0: nothing to see.
    double intensity = 0.0;
    DirectionCone normals;  ///< of a surface its normals, of a lamp the axis of its light
    /// Light leaves within this angle of the cone of normals: π/2 from surfaces.
    double emission_rad = 0.0;
    bool two_sided = false;  ///< also on the other side of the normals
};
/// Both together. A light of intensity 0 adds nothing.
LightBounds join(const LightBounds& a, const LightBounds& b);

/// Solid angle that the light shines into, each direction weighted by the cosine of what it lies
/// outside of the normals.   [Conty Estevez & Kulla 2018, eq. 1]
double emission_measure(const LightBounds& bounds);

}  // namespace dewbow
