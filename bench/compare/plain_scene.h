// SPDX-License-Identifier: Apache-2.0
#pragma once

// The few things of which the benchmark's scenes are made, so that each contestant can say them in
// its own language. Scenes of images: a pinhole, one clear convex body with flat faces, surfaces
// that only glow, even surroundings. Scenes of caustics: clear bodies, lamps, and surfaces that
// scatter or stop light.

#include <array>
#include <optional>
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

struct PlainSphere {
    Vec3 centre;          ///< m
    double radius = 0.0;  ///< m
};

/// A closed body, its triangles counter-clockwise as seen from outside; or a sphere, and no
/// triangles. Scenes of images have one, which is convex.
struct PlainBody {
    std::vector<Vec3> vertices;  ///< world frame, m
    std::vector<std::array<std::uint32_t, 3>> triangles;
    DispersionPtr index;  ///< against vacuum
    std::optional<PlainSphere> sphere{};
    int priority = 0;  ///< where bodies overlap, that of the higher one is there
    std::string name{};
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

/// A rectangle that scatters light evenly on both sides (Lambert's law), or stops it.
struct PlainReceiver {
    std::string name;
    Vec3 centre, normal, half_u, half_v;  ///< as a lamp's
    double reflectance = 0.0;             ///< 0: it stops light
};

/// A point that shines evenly into a cone.
struct PlainSpot {
    Vec3 position, direction;     ///< m; unit vector
    double half_angle_rad = 0.0;  ///< of the cone
    SpectrumPtr intensity;        ///< W sr⁻¹ nm⁻¹
    Colour<LinearSrgb> colour;    ///< of a radiance of as many W m⁻² sr⁻¹ nm⁻¹
};

/// A disc of even radiance, infinitely far away.
struct PlainSun {
    Vec3 direction;  ///< in which light travels, unit vector
    double angular_radius_rad = 0.0;
    SpectrumPtr irradiance;     ///< on a surface that faces it, W m⁻² nm⁻¹
    Colour<LinearSrgb> colour;  ///< of a radiance of as many W m⁻² sr⁻¹ nm⁻¹
};

struct PlainScene {
    PlainCamera camera;
    std::vector<PlainBody> bodies;
    DispersionPtr surrounding_index;  ///< of the air around it, against vacuum
    std::vector<PlainLamp> lamps;
    std::vector<PlainReceiver> receivers;  ///< none: a scene of images
    std::vector<PlainSpot> spots;
    std::vector<PlainSun> suns;
    SpectrumPtr surroundings;                ///< radiance from everywhere, or nullptr: none
    Colour<LinearSrgb> surroundings_colour;  ///< of that light; 0 if none
    /// XYZ (the CIE's integrals) of a spectral radiance times this are relative to the film's
    /// white.
    double film_from_xyz = 0.0;

    /// Whether light falls on things, and is not only seen through a body.
    bool has_caustics() const { return !receivers.empty(); }
};

/// Throws InputError naming the first thing that is none of these.
PlainScene plain_scene(const Scene& scene);

}  // namespace dewbow::bench
