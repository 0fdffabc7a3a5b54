// SPDX-License-Identifier: Apache-2.0
#include "rain_scenes.h"

#include <cmath>
#include <numbers>

#include "dewbow/optics/catalogue.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow::bench {

namespace {

using unit::deg;
using unit::m;

constexpr double kSunAltitude_rad = 20.0 * std::numbers::pi / 180.0;
/// Of the shower, along the view.
constexpr double kOpticalDepth = 1.0, kNear_m = 100.0, kFar_m = 1100.0;
/// Spectral radiance of the dim sky, over the sun's irradiance.
constexpr double kSkyRadiance = 0.02;

DropCloudPtr shower() {
    DropCloudRequest request;
    request.showers = {parse_drop_sizes("0.5mm")};
    request.optics = {make_dispersion(find_glass("water@20C").data),
                      make_dispersion(find_glass("air").data), 0.0};
    request.amount = RainExtinction{kOpticalDepth / (kFar_m - kNear_m)};
    request.discs = {SunDisc{}};
    return make_drop_cloud(request);
}

Material grey(double reflectance) { return {"grey", Diffuse{make_constant(reflectance)}}; }

/// Looks north, to where the bow stands; the sun is in the south.
Scene plain(int width, int height) {
    Scene scene = make_empty_scene();
    scene.film.width = width, scene.film.height = height;
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 1.7, 0}, {0, 1.7 + 150.0, -1000.0}, {0, 1, 0}));
    scene.camera.projection = Perspective{50.0 * deg};
    scene.render.max_depth = 1;
    const int ground = scene.add(grey(0.2));
    scene.shapes.push_back(
        {"ground", Plane{}, Transform<World, Object>(rotation({1, 0, 0}, -90.0 * deg)), ground});
    scene.lights.push_back(
        DistantLight{{Vec3{0.0, -std::sin(kSunAltitude_rad), -std::cos(kSunAltitude_rad)}},
                     kSunRadius,
                     make_constant(1.0)});
    const Vec3 half{2000.0, 1000.0, 0.5 * (kFar_m - kNear_m)};
    scene.rains.push_back(
        {"shower",
         ConvexRegion::box(
             Transform<World, Object>(translation({0.0, half.y, -0.5 * (kNear_m + kFar_m)})), half),
         shower(),
         {}});
    return scene;
}

/// Around the viewer and in the rain.
void add_towers(Scene& scene) {
    const int wall = scene.add(grey(0.4));
    constexpr int kTowers = 12;
    for (int i = 0; i < kTowers; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kTowers;
        const double distance = 60.0 + 70.0 * (i % 4), height = 60.0 + 40.0 * (i % 3);
        scene.shapes.push_back(
            {"tower", Box{25.0 * m, height * m, 25.0 * m},
             Transform<World, Object>(translation(
                 {distance * std::sin(angle), 0.5 * height, distance * std::cos(angle)})),
             wall});
    }
}

}  // namespace

std::vector<RainScene> make_rain_scenes(int width, int height) {
    Scene open = plain(width, height), shadowed = open;
    add_towers(shadowed);
    Scene sky = shadowed;
    sky.lights.push_back(UniformEnvironment{make_constant(kSkyRadiance)});
    return {{"open", "a plain and the sun", std::move(open)},
            {"shadowed", "with towers", std::move(shadowed)},
            {"sky", "with towers, under a dim sky", std::move(sky)}};
}

}  // namespace dewbow::bench
