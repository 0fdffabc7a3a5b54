// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light through a convex clear body, in closed form: planes, Snell and Fresnel in double, and
// nothing that a contestant uses.

#include <optional>
#include <vector>

#include "plain_scene.h"

namespace dewbow::bench {

/// What one ray becomes at a smooth boundary.
struct Parting {
    Vec3 reflected, refracted;  ///< unit; `refracted` is meaningless where all is reflected
    double reflectance = 1.0;   ///< of unpolarised light
};
/// @param d  unit direction; `normal` unit, against it (d · normal <= 0).
/// @param n  index behind the boundary over that before it.          [Born & Wolf §1.5.2]
Parting part(Vec3 d, Vec3 normal, double n);

/// The faces of a convex body as planes.
class ConvexFaces {
public:
    /// Throws InputError if a vertex lies outside the plane of any triangle by more than 1e-6 of
    /// the size.
    explicit ConvexFaces(const PlainBody& body);

    struct Crossing {
        double distance = 0.0;
        Vec3 normal;  ///< outwards
    };
    /// Where a ray from outside enters, at distance > 0.
    std::optional<Crossing> entry(Vec3 origin, Vec3 d) const;
    /// Where a ray from inside, or from a face inwards, leaves.
    Crossing exit(Vec3 origin, Vec3 d) const;
    /// Whether the point is behind all faces.
    bool holds(Vec3 p) const;
    std::size_t size() const { return planes_.size(); }

private:
    struct Face {
        Vec3 normal;
        double offset = 0.0;  ///< normal · p of its points
    };
    std::vector<Face> planes_;
};

/// Distance along the ray to a lamp, either side; nothing if it misses.
std::optional<double> distance_to(const PlainLamp& lamp, Vec3 origin, Vec3 d);

}  // namespace dewbow::bench
