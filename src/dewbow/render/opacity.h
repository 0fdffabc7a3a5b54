// SPDX-License-Identifier: Apache-2.0
#pragma once

// Surfaces that are there in part: leaves cut out of rectangles by a picture, veils.

#include "dewbow/math/vector.h"

namespace dewbow {

/// How opaque the shapes of a scene are, place by place.
class Opacity {
public:
    virtual ~Opacity() = default;
    /// Whether any point of that shape may be less than opaque. Others are never asked about.
    virtual bool tests(int shape) const = 0;
    /// The share, 0 to 1, of that surface which is there.  @param primitive  triangle of a mesh,
    /// face of a polyhedron.  @param u, v  on triangles the weights of vertices 1 and 2, on other
    /// shapes the coordinates of their chart (AnalyticShape::chart).
    virtual double at(int shape, int primitive, double u, double v) const = 0;
};

/// One meeting of a ray with a surface.
struct Meeting {
    Vec3 origin, direction;  ///< of the ray
    int shape = 0, primitive = 0;
    bool inward = false;  ///< whether the ray goes against the outward normal
};

/// Whether a surface of that opacity is there for the ray: with probability `opacity`, decided by a
/// hash of the meeting alone, so that the same ray always finds the same answer and different rays,
/// surfaces and sides are independent. [The idea: Pharr, Jakob & Humphreys, "Physically Based
/// Rendering", 4th ed. 2023, §7.1.1]
bool is_there(double opacity, const Meeting& meeting);

}  // namespace dewbow
