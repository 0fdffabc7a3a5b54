// SPDX-License-Identifier: Apache-2.0

// Light paths alone against closed forms: a lamp without extent behind something smooth, which no
// camera path finds.

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/render/caustics/caustics.h"
#include "dewbow/render/prepared_scene.h"
#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kSide = 8;
constexpr std::uint64_t kPaths = 1 << 17;
/// Of a pixel, in standard errors (64 pixels: a false alarm in 3e4 changes).
constexpr double kSigmas = 5.0;
/// Of all pixels together, likewise (a false alarm in 1e5).
constexpr double kSigmasOfAll = 4.5;

/// What light paths bring to the pixels: Y, 1 of the constant spectrum 1, and its standard error.
struct Brought {
    std::array<double, kSide * kSide> y{}, error{};
    double sum = 0.0, error_of_sum = 0.0;
};

Brought trace(const Scene& scene) {
    const auto estimator = make_caustics_estimator(scene);
    FilmLayout layout;
    layout.width = layout.height = kSide;
    layout.crop = {0, 0, kSide, kSide};
    Brought result;
    constexpr double kPath = 1.0 / kPaths;
    for (std::uint64_t first = 0; first < kPaths; first += 4096) {
        SplatList splats(layout);
        estimator->trace_light({0, first, first + 4096}, splats);
        EXPECT_EQ(splats.invalid(), 0);
        for (const Splat& splat : splats.splats()) {
            const double y = splat.xyz[1] * kPath;
            result.y[splat.pixel] += y;
            result.error[splat.pixel] += y * y;
            result.sum += y;
        }
    }
    for (double& error : result.error) result.error_of_sum += error, error = std::sqrt(error);
    result.error_of_sum = std::sqrt(result.error_of_sum);
    return result;
}

Scene scene_with_floor(double reflectance) {
    Scene scene = empty_scene(4);
    add(scene, Rectangle{4.0 * m, 4.0 * m}, diffuse(reflectance));
    scene.film.width = scene.film.height = kSide;
    scene.film.filter = {FilterKind::box, 0.5};
    scene.render.packet = 4;
    scene.render.caustics.aimed = false;
    return scene;
}

/// 2r / (1 + r), with r the mean of both of Fresnel's reflectances.
double reflectance_of_pane(double cos_i, double n) {
    const double cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (n * n));
    const double s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    const double p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const double r = 0.5 * (s * s + p * p);
    return 2.0 * r / (1.0 + r);
}

/// The floor's radiance ρ I cos θ (1 − R(θ)) / (π d²), pixel by pixel.
TEST(LightPaths, APointBehindAPane) {
    constexpr double kReflectance = 0.7, kHeight = 1.0, kIndex = 1.5;
    Scene scene = scene_with_floor(kReflectance);
    const auto index = make_dispersion({"constant", {kIndex}, IndexReference::vacuum});
    add(scene, Rectangle{0.8 * m, 0.8 * m}, {"pane", ThinDielectric{index}},
        translation({0, 0, 0.6}));
    scene.lights.push_back(PointLight{Point<World>{{0, 0, kHeight}}, make_constant(1.0)});
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, -1.3, 0.8}, {0, 0.1, 0}, {0, 0, 1}));
    scene.camera.projection = Perspective{20.0 * deg};
    const Brought brought = trace(scene);
    const PreparedScene prepared(scene);
    constexpr int kParts = 4;  // the mean over a pixel changes by 1e-4 with 8
    double sum = 0.0;
    for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
        double mean = 0.0;
        for (int i = 0; i < kParts * kParts; ++i) {
            const Ray ray =
                prepared.camera.ray_through(pixel % kSide + (i % kParts + 0.5) / kParts,
                                            pixel / kSide + (i / kParts + 0.5) / kParts);
            const Vec3 at = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
            const double d2 = dot(at, at) + kHeight * kHeight, cosine = kHeight / std::sqrt(d2);
            mean += kReflectance * cosine * (1.0 - reflectance_of_pane(cosine, kIndex)) /
                    (kPi * d2) / (kParts * kParts);
        }
        const auto p = std::size_t(pixel);
        EXPECT_NEAR(brought.y[p], mean, kSigmas * brought.error[p]) << pixel;
        sum += mean;
    }
    EXPECT_NEAR(brought.sum, sum, kSigmasOfAll * brought.error_of_sum);
    EXPECT_LT(brought.error_of_sum, 0.01 * sum);
}

/// A mirror whose shading normals all lean by an angle sends parallel light on as a mirror does
/// that leans; but what falls on it is by its true normal, and what it sends by what is seen of it:
/// E A |cos θ_c| where A is its area and θ_c the angle of what leaves to the true normal.
TEST(LightPaths, ALeaningShadingNormalKeepsWhatIsSeen) {
    constexpr double kLean = 0.2, kHalf = 0.2, kReflectance = 0.9, kFloor = 0.8;
    auto quad = std::make_shared<Mesh>(
        *mesh({{-kHalf, -kHalf, 1}, {kHalf, -kHalf, 1}, {kHalf, kHalf, 1}, {-kHalf, kHalf, 1}},
              {{0, 2, 1}, {0, 3, 2}}));
    const Vec3 normal{-std::sin(kLean), 0.0, -std::cos(kLean)};
    for (int i = 0; i < 4; ++i) quad->normals.push_back({normal});
    Scene scene = scene_with_floor(kFloor);
    add(scene, std::shared_ptr<const Mesh>(quad), {"mirror", Mirror{make_constant(kReflectance)}});
    const Vec3 up = normalised({2.0, 0.0, 1.0});  // of the light
    scene.lights.push_back(DistantLight{Dir<World>{up}, 0.0 * deg, make_constant(1.0)});
    scene.shapes[0].world_from_object = Transform<World, Object>(translation({0, 0, -0.5}));
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, -3, 0.2}, {1.3, 0, -0.5}, {0, 0, 1}));
    const Vec3 down = up - normal * (2.0 * dot(up, normal));
    const double flux = 4.0 * kHalf * kHalf * kReflectance * std::abs(down.z);
    // Radiance × area that all pixels see, each with its pixels_per_m2 at the patch: a splat's
    // worth for each part of the patch.
    const PreparedScene prepared(scene);
    constexpr int kParts = 32;
    double sum = 0.0;
    for (int i = 0; i < kParts * kParts; ++i) {
        const Vec3 from{kHalf * (2.0 * (i % kParts + 0.5) / kParts - 1.0),
                        kHalf * (2.0 * (i / kParts + 0.5) / kParts - 1.0), 1.0};
        const Vec3 at = from - down * ((from.z + 0.5) / down.z);
        std::array<Seen, 2> seen;
        ASSERT_EQ(prepared.camera.seen(at, {0.5, 0.5}, 550.0, seen), 1);
        sum +=
            kFloor / kPi * flux / (kParts * kParts) * seen[0].pixels_per_m2 * seen[0].direction.z;
    }
    const Brought brought = trace(scene);
    EXPECT_NEAR(brought.sum, sum, kSigmasOfAll * brought.error_of_sum);
    EXPECT_LT(brought.error_of_sum, 0.01 * sum);
}

}  // namespace
}  // namespace dewbow
