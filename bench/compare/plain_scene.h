// SPDX-License-Identifier: Apache-2.0
#pragma once

// The few things of which the benchmark's scenes are made, each of which every contestant can say
// in its own language: a pinhole, one clear convex body with flat faces, surfaces that only glow,
// even surroundings.

#include <array>
#include <string>
#include <vector>

#include "dewbow/scene/scene.h"
#include "dewbow/spectrum/colour.h"

namespace dewbow::bench {

/// A pinhole whose pixels are boxes: a pixel is the mean over its square. World frame, metres.
struct PlainCamera {
    Vec3 eye;
    Vec3 right, up, forward;             ///< unit vectors; `up` is upright in the picture
    double tan_half_vertical_fov = 0.0;  ///< half the picture's height at distance 1
    int width = 0, height = 0;           ///< pixels, square

    /// Direction through the film's point (x, y), in pixels from the top left corner. Not unit.
    Vec3 direction(double x, double y) const;
};

/// A closed convex body, its triangles counter-clockwise as seen from outside.
struct PlainBody {
    std::vector<Vec3> vertices;  ///< world frame, m
    std::vector<std::array<std::uint32_t, 3>> triangles;
    DispersionPtr index;  ///< against vacuum
};

enum class LampShape { rectangle, disc };

/// A flat surface that reflects nothing, and gives off the same light in all directions of the side
/// to which its normal points (or of both).
struct PlainLamp {
    std::string name;
    LampShape shape = LampShape::rectangle;
    Vec3 centre, normal;   ///< m; unit vector
    Vec3 half_u, half_v;   ///< to the middles of two sides (rectangle), along two radii (disc), m:
                           ///< normal = u × v
    SpectrumPtr radiance;  ///< W m⁻² sr⁻¹ nm⁻¹
    Colour<LinearSrgb> colour;  ///< of that light: (1, 1, 1) is the film's white
    bool two_sided = false;
};

struct PlainScene {
    PlainCamera camera;
    PlainBody body;
    DispersionPtr surrounding_index;  ///< of the air around it, against vacuum
    std::vector<PlainLamp> lamps;
    SpectrumPtr surroundings;                ///< radiance from everywhere, or nullptr: none
    Colour<LinearSrgb> surroundings_colour;  ///< of that light; 0 if none
    /// XYZ (the CIE's integrals) of a spectral radiance times this are relative to the film's
    /// white.
    double film_from_xyz = 0.0;
};

/// Throws InputError naming the first thing that is none of these.
PlainScene plain_scene(const Scene& scene);

}  // namespace dewbow::bench
