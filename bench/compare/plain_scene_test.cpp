// SPDX-License-Identifier: Apache-2.0
#include "plain_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "measurement.h"

namespace dewbow::bench {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(DEWBOW_SOURCE_DIR) / "bench" / "scenes";
constexpr double kRounding = 1e-9;

BenchScene load(const std::string& name) {
    return load_bench_scene(kScenes / (name + ".toml"), 40, 20);
}

/// By the divergence theorem: positive if the triangles face outwards, and too small if one is
/// missing.
double volume_m3(const PlainBody& body) {
    double six_volumes = 0.0;
    for (const auto& t : body.triangles)
        six_volumes += dot(body.vertices[t[0]], cross(body.vertices[t[1]], body.vertices[t[2]]));
    return six_volumes / 6.0;
}

TEST(PlainScene, BodiesAreClosedAndFaceOutwards) {
    // Prism: side² sin(apex)/2 × length; slab: its three sides.
    EXPECT_NEAR(volume_m3(load("disc").plain.bodies[0]),
                0.5 * 2.0 * 2.0 * std::sin(std::numbers::pi / 3.0) * 4.0, kRounding);
    EXPECT_NEAR(volume_m3(load("slab").plain.bodies[0]), 4.0 * 4.0 * 0.6, kRounding);
}

TEST(PlainScene, CameraLooksThroughTheFilmsCorners) {
    const PlainCamera camera = load("slab").plain.camera;
    const Vec3 centre = camera.direction(20.0, 10.0);
    EXPECT_NEAR(length(centre - Vec3{0.0, 0.0, -1.0}), 0.0, kRounding);
    // 12° from the lower to the upper edge; twice that, in tangents, across.
    const double half = std::tan(6.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(length(camera.direction(0.0, 0.0) - Vec3{-2.0 * half, half, -1.0}), 0.0, kRounding);
    EXPECT_NEAR(length(camera.direction(40.0, 20.0) - Vec3{2.0 * half, -half, -1.0}), 0.0,
                kRounding);
}

TEST(PlainScene, TheWhiteLampIsTheFilmsWhite) {
    /// D65's chromaticity is rounded to four digits in the definition of sRGB.
    constexpr double kWhite = 1e-3;
    for (const PlainLamp& lamp : load("disc").plain.lamps)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(lamp.colour[c], 1.0, kWhite) << lamp.name;
}

TEST(PlainScene, LampsAreWhereTheSceneSays) {
    const PlainScene scene = load("slab").plain;
    const PlainLamp& bar = scene.lamps.front();
    EXPECT_EQ(bar.name, "upper bar");
    EXPECT_NEAR(length(bar.centre - Vec3{0.0, 0.5, -2.5}), 0.0, kRounding);
    EXPECT_NEAR(length(bar.half_u - Vec3{0.25, 0.0, 0.0}), 0.0, kRounding);
    EXPECT_NEAR(length(normalised(cross(bar.half_u, bar.half_v)) - bar.normal), 0.0, kRounding);
}

TEST(PlainScene, WhatNotAllCanSayIsRefused) {
    const auto refuses = [](const auto& change) {
        Scene scene = load("disc").scene;
        change(scene);
        EXPECT_THROW(plain_scene(scene), InputError);
    };
    refuses([](Scene& scene) { scene.camera.projection = Orthographic{}; });
    refuses([](Scene& scene) { scene.film.filter = PixelFilter{}; });
    refuses([](Scene& scene) { scene.materials[0].surface = Mirror{}; });
    refuses([](Scene& scene) { scene.shapes.push_back(scene.shapes[0]); });
    refuses([](Scene& scene) { scene.shapes.erase(scene.shapes.begin()); });
    refuses([](Scene& scene) { scene.lights.push_back(PointLight{}); });
}

}  // namespace
}  // namespace dewbow::bench
