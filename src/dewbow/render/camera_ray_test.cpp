// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/camera_ray.h"

#include <gtest/gtest.h>

#include <numbers>

#include "dewbow/render/environment.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-14;
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

// ---- other projections -------------------------------------------------------------------------

TEST(CameraRays, OrthographicRaysAreParallel) {
    Scene scene = scene_of(40, 20);
    const Vec3 eye{1, 2, 3}, target{-1, 0.5, 2};
    scene.camera.world_from_camera = Transform<World, Camera>(looking_at(eye, target, {0, 1, 0}));
    scene.camera.projection = Orthographic{5.0 * unit::m};
    const CameraRays camera(scene);
    const Ray top = camera.ray_through(20, 0), bottom = camera.ray_through(20, 20);
    EXPECT_NEAR(length(top.origin - bottom.origin), 5.0, kRounding);
    EXPECT_NEAR(length(camera.ray_through(0, 3).origin - camera.ray_through(40, 3).origin), 10.0,
                kRounding);
    EXPECT_GT(top.origin.y, bottom.origin.y);
    for (const Ray& ray : {top, bottom})
        EXPECT_LT(length(ray.direction - camera.axis()), kRounding);
    EXPECT_LT(length(camera.ray_through(20, 10).origin - eye), kRounding);
    // Depth is the way along any ray.
    EXPECT_NEAR(camera.depth_of(top.origin + top.direction * 7.0), 7.0, kRounding);
}

TEST(CameraRays, DepthIsAlongTheAxisAndOfPanoramasTheDistance) {
    Scene scene = scene_of(40, 20);
    EXPECT_NEAR(CameraRays(scene).depth_of({3, 0, -4}), 4.0, kRounding);
    scene.camera.projection = Panorama{};
    EXPECT_NEAR(CameraRays(scene).depth_of({3, 0, -4}), 5.0, kRounding);
    EXPECT_NEAR(CameraRays(scene).depth_of({3, 0, 4}), 5.0, kRounding);
}

// Each pixel of a panorama looks to where an environment has that pixel.
TEST(CameraRays, PanoramasAreEnvironments) {
    auto studio = std::make_shared<ImageEnvironment>(*make_studio_environment());
    Scene scene = scene_of(studio->width, studio->height);
    scene.camera.projection = Panorama{};
    const CameraRays camera(scene);
    const EnvironmentMap map(studio);
    for (int y = 0; y < studio->height; y += 7)
        for (int x = 0; x < studio->width; x += 3) {
            const auto seen = map.radiance(camera.ray_through(x + 0.5, y + 0.5).direction);
            const auto& pixel = studio->pixels[std::size_t(y * studio->width + x)];
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(seen[c], pixel[c], 1e-9 * (1.0 + pixel[c])) << x << " " << y;
        }
    // Beyond the zenith the way goes on over it.
    const Vec3 over = camera.ray_through(10.0, -1.0).direction,
               same = camera.ray_through(10.0 + studio->width / 2.0, 1.0).direction;
    EXPECT_LT(length(over - same), kRounding);
}

// ---- stereo ------------------------------------------------------------------------------------

constexpr double kSeparation_m = 0.2, kConvergence_m = 3.0;

Scene stereo_scene(StereoLayout layout) {
    Scene scene = scene_of(80, 40);
    scene.camera.stereo = StereoPair{kSeparation_m * unit::m, kConvergence_m * unit::m, layout};
    return scene;
}

/// Where in the picture `point` is seen by the eye of the pixels around (x0, y0), found by Newton's
/// method on the ray's own deviation: without the camera's formula.
std::array<double, 2> place_of(const CameraRays& camera, Vec3 point, double x0, double y0) {
    double x = x0, y = y0;
    const auto miss = [&](double px, double py) {
        const Ray ray = camera.ray_through(px, py);
        const Vec3 at = ray.origin + ray.direction * ((point.z - ray.origin.z) / ray.direction.z);
        return at - point;
    };
    for (int i = 0; i < 3; ++i) {  // linear: one step is enough but for rounding
        const Vec3 here = miss(x, y);
        const double dx = miss(x + 0.25, y).x - here.x, dy = miss(x, y + 0.25).y - here.y;
        x -= 0.25 * here.x / dx, y -= 0.25 * here.y / dy;
    }
    return {x, y};
}

TEST(CameraRays, StereoDisparityIsThatOfSimilarTriangles) {
    const double half_height = std::tan(std::numbers::pi / 6.0);
    for (const StereoLayout layout : {StereoLayout::side_by_side, StereoLayout::over_under}) {
        const bool beside = layout == StereoLayout::side_by_side;
        const CameraRays camera(stereo_scene(layout));
        const double width = beside ? 40.0 : 80.0, height = beside ? 40.0 : 20.0;
        for (const double distance : {1.5, kConvergence_m, 20.0}) {
            const Vec3 point{0.11, -0.07, -distance};
            const auto left = place_of(camera, point, 0.5 * width, 0.5 * height);
            auto right = place_of(camera, point, (beside ? 1.5 : 0.5) * width,
                                  (beside ? 0.5 : 1.5) * height);
            right[beside ? 0 : 1] -= beside ? width : height;
            const double pixels = 0.5 * height / half_height;
            EXPECT_NEAR(left[0] - right[0],
                        pixels * kSeparation_m * (1.0 / distance - 1.0 / kConvergence_m), 1e-9)
                << distance;
            EXPECT_NEAR(left[1], right[1], 1e-9) << distance;
            EXPECT_NEAR(left[1], 0.5 * height - pixels * point.y / distance, 1e-9);
        }
    }
}

TEST(CameraRays, OneEyeIsHalfOfThePair) {
    const CameraRays pair(stereo_scene(StereoLayout::side_by_side));
    for (const StereoLayout layout : {StereoLayout::left, StereoLayout::right}) {
        Scene scene = stereo_scene(layout);
        scene.film.width = 40;
        const CameraRays eye(scene);
        const double start = layout == StereoLayout::left ? 0.0 : 40.0;
        const Ray a = eye.ray_through(13.25, 7.5), b = pair.ray_through(start + 13.25, 7.5);
        EXPECT_EQ(a.origin, b.origin);
        EXPECT_LT(length(a.direction - b.direction), kRounding);
        EXPECT_NEAR(a.origin.x, layout == StereoLayout::left ? -0.1 : 0.1, kRounding);
    }
}

// The filter reaches over the seam between the eyes; each pixel stays with its own.
TEST(CameraRays, EyesDoNotMixAtTheSeam) {
    Scene scene = stereo_scene(StereoLayout::side_by_side);
    scene.film.filter = {FilterKind::box, 4.0};
    const CameraRays camera(scene);
    for (std::uint32_t i = 0; i < 64; ++i) {
        EXPECT_LT(camera.ray(39, 20, SampleKey(stream_key(0, 39, 20), i)).origin.x, 0.0);
        EXPECT_GT(camera.ray(40, 20, SampleKey(stream_key(0, 40, 20), i)).origin.x, 0.0);
    }
}

}  // namespace
}  // namespace dewbow
