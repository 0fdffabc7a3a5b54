// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/camera_ray.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewbow {
namespace {

constexpr double kRounding = 1e-14;
/// The filter's table has 500 cells: the variance of a step within a cell is 1/12 of its square.
constexpr double kTable = 1e-5;

struct Moments {
    double mean = 0.0, variance = 0.0;
};
Moments sampled(const PixelFilter& filter) {
    const FilterSampler sampler(filter);
    constexpr int kCount = 200000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double x = sampler.sample((i + 0.5) / kCount);
        EXPECT_LE(std::abs(x), filter.radius);
        sum += x, squares += x * x;
    }
    return {sum / kCount, squares / kCount - sum * sum / kCount / kCount};
}

TEST(CameraRays, FiltersHaveTheirVariance) {
    const Moments box = sampled({FilterKind::box, 0.5});
    EXPECT_NEAR(box.mean, 0.0, kTable);
    EXPECT_NEAR(box.variance, 0.25 / 3.0, kTable);
    // A Gaussian cut at three standard deviations: 1 − 6 φ(3) / (2 Φ(3) − 1).
    const Moments gaussian = sampled({FilterKind::gaussian, 1.5});
    const double phi = std::exp(-4.5) / std::sqrt(2.0 * std::numbers::pi);
    EXPECT_NEAR(gaussian.mean, 0.0, kTable);
    EXPECT_NEAR(gaussian.variance, 0.25 * (1.0 - 6.0 * phi / std::erf(3.0 / std::sqrt(2.0))),
                kTable);
    // Σ a_j cos(j π (x + 1)): ∫ x² cos(jπ(x+1)) = 4 / (jπ)² over [−1, 1], and 2/3 for j = 0.
    const Moments harris = sampled({FilterKind::blackman_harris, 1.5});
    const double a[] = {0.35875, -0.48829, 0.14128, -0.01168};
    double second = a[0] * 2.0 / 3.0;
    for (int j = 1; j < 4; ++j) second += a[j] * 4.0 / std::pow(j * std::numbers::pi, 2.0);
    EXPECT_NEAR(harris.mean, 0.0, kTable);
    EXPECT_NEAR(harris.variance, 2.25 * second / (2.0 * a[0]), 2.0 * kTable);
}

Scene scene_of(int width, int height) {
    Scene scene = make_empty_scene();
    scene.film.width = width;
    scene.film.height = height;
    scene.camera.projection = Perspective{60.0 * unit::deg};
    return scene;
}

TEST(CameraRays, LookAlongMinusZWithYUp) {
    const CameraRays camera(scene_of(40, 20));
    const Vec3 middle = camera.ray_through(20, 10).direction;
    EXPECT_NEAR(middle.z, -1.0, kRounding);
    // The upper edge is 30° up, and the picture is twice as wide.
    const Vec3 top = camera.ray_through(20, 0).direction;
    EXPECT_NEAR(top.y / -top.z, std::tan(std::numbers::pi / 6.0), kRounding);
    const Vec3 right = camera.ray_through(40, 10).direction;
    EXPECT_NEAR(right.x / -right.z, 2.0 * std::tan(std::numbers::pi / 6.0), kRounding);
    EXPECT_NEAR(length(camera.ray_through(3, 17).direction), 1.0, kRounding);
}

TEST(CameraRays, StandWhereTheCameraStands) {
    Scene scene = scene_of(40, 20);
    const Vec3 eye{1, 2, 3}, target{-1, 0.5, 2};
    scene.camera.world_from_camera = Transform<World, Camera>(looking_at(eye, target, {0, 1, 0}));
    const CameraRays camera(scene);
    const Ray ray = camera.ray_through(20, 10);
    EXPECT_LT(length(ray.origin - eye), kRounding);
    EXPECT_LT(length(ray.direction - normalised(target - eye)), kRounding);
    EXPECT_LT(length(camera.axis() - normalised(target - eye)), kRounding);
    EXPECT_EQ(ray.from.shape, -1);
}

TEST(CameraRays, SamplesFillTheFilterAroundThePixel) {
    Scene scene = scene_of(40, 20);
    scene.film.filter = {FilterKind::box, 0.5};
    const CameraRays camera(scene);
    const double half = std::tan(std::numbers::pi / 6.0);
    double mean_x = 0.0, mean_y = 0.0;
    constexpr int kCount = 4096;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const Ray ray = camera.ray(7, 3, SampleKey(stream_key(0, 7, 3), i));
        const double x = 20.0 * (1.0 + ray.direction.x / -ray.direction.z / (2.0 * half));
        const double y = 10.0 * (1.0 - ray.direction.y / -ray.direction.z / half);
        ASSERT_TRUE(x >= 7.0 - 1e-9 && x <= 8.0 + 1e-9 && y >= 3.0 - 1e-9 && y <= 4.0 + 1e-9);
        mean_x += x / kCount, mean_y += y / kCount;
    }
    // Stratified: a whole (0, 2)-net.
    EXPECT_NEAR(mean_x, 7.5, 1e-3);
    EXPECT_NEAR(mean_y, 3.5, 1e-3);
}

}  // namespace
}  // namespace dewbow
