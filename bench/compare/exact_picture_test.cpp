// SPDX-License-Identifier: Apache-2.0
#include "exact_picture.h"

#include <gtest/gtest.h>

#include "clear_body.h"
#include "measurement.h"

namespace dewbow::bench {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(DEWBOW_SOURCE_DIR) / "bench" / "scenes";
constexpr double kRounding = 1e-12;
/// Chains are cut where 1e-5 of the light is left.
constexpr double kCut = 1.1e-5;

/// A body of index 1.5 in vacuum, seen along −z from z = 5, with a lamp of radiance 1 behind.
PlainScene before_lamp(PlainBody body) {
    PlainScene scene;
    scene.camera = {{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0.1, 2, 2};
    scene.bodies.push_back(std::move(body));
    scene.bodies[0].index = make_dispersion({"constant", {1.5}, IndexReference::vacuum});
    scene.surrounding_index = vacuum();
    PlainLamp lamp;
    lamp.name = "lamp";
    lamp.centre = {0, 0, -5};
    lamp.normal = {0, 0, 1};
    lamp.half_u = {1, 0, 0};
    lamp.half_v = {0, 1, 0};
    lamp.radiance = make_constant(1.0);
    scene.lamps.push_back(lamp);
    scene.film_from_xyz = 1.0 / cie_y_integral();
    return scene;
}

PlainBody cube(double half) {
    PlainBody body;
    for (int corner = 0; corner < 8; ++corner)
        body.vertices.push_back(
            {corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? half : -half});
    body.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return body;
}

// Light that goes to and fro in a plate: T = (1 − R)² (1 + R² + R⁴ + …) = (1 − R)/(1 + R), R = 0.04
// for n = 1.5.
TEST(ExactPicture, PlateLetsThroughWhatTheSeriesSays) {
    const PlainScene scene = before_lamp(cube(1.0));
    EXPECT_NEAR(exact_radiance(scene, 1.0, 1.0, 550.0), 0.96 / 1.04, kCut);
}

TEST(ExactPicture, LampsHaveAFrontAndABack) {
    PlainScene scene = before_lamp(cube(1.0));
    scene.lamps[0].normal = {0, 0, -1};
    EXPECT_EQ(exact_radiance(scene, 1.0, 1.0, 550.0), 0.0);
    scene.lamps[0].two_sided = true;
    EXPECT_NEAR(exact_radiance(scene, 1.0, 1.0, 550.0), 0.96 / 1.04, kCut);
    scene.lamps[0].centre = {0, 0, 3};
    EXPECT_EQ(exact_radiance(scene, 1.0, 1.0, 550.0), 1.0);
}

// In surroundings that are the same everywhere a clear body cannot be seen.
TEST(ExactPicture, ABodyInEvenSurroundingsIsInvisible) {
    for (const char* name : {"disc", "diamond"}) {
        BenchScene bench = load_bench_scene(kScenes / (std::string(name) + ".toml"), 16, 16);
        bench.plain.lamps.clear();
        bench.plain.surroundings = make_constant(1.0);
        for (double x = 0.5; x < 16.0; x += 1.0)
            for (double y = 0.5; y < 16.0; y += 1.0)
                EXPECT_NEAR(exact_radiance(bench.plain, x, y, 500.0), 1.0, kCut);
    }
}

// D = i + i' − A, and sin i = n sin r on both sides.
TEST(ExactPicture, PrismDeviatesAsItsFormulaSays) {
    constexpr double kApex_rad = 1.0471975511965976, kIndex = 1.8, kIncidence_rad = 1.1;
    const double r1 = std::asin(std::sin(kIncidence_rad) / kIndex), r2 = kApex_rad - r1;
    const double deviation = kIncidence_rad + std::asin(kIndex * std::sin(r2)) - kApex_rad;
    // Faces whose outer normals lie 30° above the horizon; the ray comes from the left, below.
    const double half = 0.5 * kApex_rad;
    const Vec3 left{-std::cos(half), std::sin(half), 0.0}, right{-left.x, left.y, 0.0};
    const double elevation = kIncidence_rad - half;
    const Vec3 d{std::cos(elevation), std::sin(elevation), 0.0};
    const Parting in = part(d, left, kIndex);
    const Parting out = part(in.refracted, -right, 1.0 / kIndex);
    EXPECT_NEAR(std::acos(dot(d, out.refracted)), deviation, kRounding);
}

// Brewster: at tan i = n nothing of the parallel polarisation is reflected, so that R = sin²(i −
// r)/2 = cos²(2i)/2.
TEST(ExactPicture, ReflectanceAtBrewstersAngle) {
    const double i = std::atan(1.5), c = std::cos(2.0 * i);
    const Parting parting = part({std::sin(i), -std::cos(i), 0}, {0, 1, 0}, 1.5);
    EXPECT_NEAR(parting.reflectance, 0.5 * c * c, kRounding);
    EXPECT_EQ(part({0.8, -0.6, 0}, {0, 1, 0}, 1.0 / 1.5).reflectance, 1.0);
}

TEST(ExactPicture, TheLampOfTheFilmsWhiteIsWhite) {
    const BenchScene bench = load_bench_scene(kScenes / "disc.toml", 32, 32);
    const Picture picture = exact_picture(bench.plain, 512, 1);
    const std::vector<bool> card = pixels_of_lamp(bench.plain, "card");
    int pixels = 0;
    /// Half a stratum of 512 by which all are shifted at most, times the range of the integrand,
    /// about 2.5.
    constexpr double kQuadrature = 2.5e-3;
    for (std::size_t i = 0; i < card.size(); ++i) {
        if (!card[i]) continue;
        ++pixels;
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(picture.pixels[i][c], 1.0, kQuadrature);
    }
    EXPECT_GE(pixels, 4);
}

}  // namespace
}  // namespace dewbow::bench
