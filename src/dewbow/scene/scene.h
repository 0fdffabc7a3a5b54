// SPDX-License-Identifier: Apache-2.0
#pragma once

// The neutral description: what every importer makes and every renderer takes.

#include <string>
#include <vector>

#include "dewbow/scene/camera.h"
#include "dewbow/scene/caustics_settings.h"
#include "dewbow/scene/distributed_1989.h"
#include "dewbow/scene/light.h"
#include "dewbow/scene/material.h"
#include "dewbow/scene/medium.h"
#include "dewbow/scene/rain.h"
#include "dewbow/scene/rain_settings.h"
#include "dewbow/scene/shape.h"
#include "dewbow/sky/aerial.h"
#include "dewbow/sky/paper_fog.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// Most surfaces that a path may be allowed to meet.
inline constexpr int kMostDepth = 100'000;
/// Most samples of one pixel: what the film's sums have room for.
inline constexpr int kMostSamples = 1 << 24;
/// Most spectral bins of a picture: half a nanometre each.
inline constexpr int kMostSpectralBins = 940;

struct RenderSettings {
    int samples_per_pixel = 64;
    std::uint64_t seed = 0;
    int packet = 8;  ///< wavelengths a path: 1, 4, 8 or 16
    WavelengthSampling wavelengths = WavelengthSampling::visual;
    /// Most surfaces that a path meets; 0 shows only what gives off light itself.
    int max_depth = 64;
    /// From this vertex on paths end by Russian roulette; max_depth and beyond = never.
    int roulette_depth = 6;
    Distributed1989Settings distributed_1989;
    CausticsSettings caustics;
    RainSettings rain;
};

struct Scene {
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<Light> lights;
    std::vector<Rain> rains;
    /// The air that fills the surroundings, where distance is to tell; or nullptr.
    AerialPtr aerial;
    /// Needs a DistantLight, whose first is its sun.
    std::optional<PaperRainbow> paper_rainbow;
    CameraView camera;                ///< takes the picture
    std::vector<CameraView> cameras;  ///< all that a file offers, by name; its own choice first
    Film film;
    RenderSettings render;
    /// What fills the space between bodies.
    MediumPtr surroundings;

    /// Adds a material and returns its index.
    int add(Material material);
};

/// A scene of nothing, in air.
Scene make_empty_scene();

struct Bounds {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    bool empty() const { return low.x > high.x; }
    Vec3 centre() const { return (low + high) * 0.5; }
    double radius() const { return empty() ? 0.0 : 0.5 * length(high - low); }
    void add(Vec3 p);
    /// Whether the two have a point in common, if only on their faces.
    bool overlaps(const Bounds& b) const {
        return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
               low.z <= b.high.z && b.low.z <= high.z;
    }
};

/// Bounds of all shapes but infinite planes, in the world frame.
Bounds bounds_of(const Scene& scene);
Bounds bounds_of(const Shape& shape);
/// Bounds of each shape; empty ones of infinite planes. Of a mesh that stands in very many places
/// they may be wider than need be: the boxes around the mesh are turned, and not all its vertices.
std::vector<Bounds> bounds_of_shapes(const Scene& scene);
/// Bounds of what lies within `box`, and in the ball around it, after a map.
Bounds bounds_of_box(const Bounds& box, const Affine& to_from_box);

/// A camera at a three-quarter view that holds `bounds` wholly, for scenes that bring none.
CameraView frame_bounds(const Bounds& bounds, double aspect);

/// A photographer's studio: soft boxes before dark grey, for scenes that bring no light.
std::shared_ptr<const ImageEnvironment> make_studio_environment();

/// Throws InputError naming the first thing that no renderer could work with: an index out of
/// range, a missing spectrum, a number out of its range.
void validate(const Scene& scene);
/// The part of it that is about camera, film and rendering.
void validate_view(const Scene& scene);

/// The first DistantLight, which is the sun of a rainbow; nullptr if there is none.
const DistantLight* first_sun(const Scene& scene);

}  // namespace dewbow
