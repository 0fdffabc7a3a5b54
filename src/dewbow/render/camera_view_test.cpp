// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "dewbow/render/camera_kinds.h"
#include "dewbow/render/camera_ray.h"

namespace dewbow {
namespace {

// Cameras of all kinds. Their filter is next to nothing wide, so that a sample is the ray through
// its pixel's centre and through a point of the lens that its key tells: the oracle is ray() alone.

constexpr double kFilterRadius = 1e-9;
/// Of places on the film, in pixels: the filter's width and rounding in pictures of 2000 pixels.
constexpr double kPlace = 1e-7;
/// Of densities: one-sided differences of second order over two pixels of 2000.
constexpr double kDifferences = 5e-5;
constexpr double kRounding = 1e-13;

Film fine_film() {
    Film film;
    film.width = 2000;
    film.height = 1000;
    film.filter = {FilterKind::box, kFilterRadius};
    return film;
}

/// The ray of the centre of pixel (x, y) at a wavelength.
Ray ray_of(const CameraRays& camera, int x, int y, const SampleKey& key, double lambda_nm) {
    if (!camera.disperses()) return camera.ray(x, y, key);
    return camera.rays(x, y, key, {&lambda_nm, 1}).ray(0);
}

struct Case {
    int x, y;
    double distance, lambda_nm;
};
constexpr Case kCases[] = {{3, 5, 0.4, 410.0},        {700, 320, 1.7, 587.5618},
                           {999, 499, 3.0, 700.0},    {1000, 500, 11.0, 480.0},
                           {1996, 998, 250.0, 800.0}, {1500, 20, 2.5, 550.0}};

/// Of the eyes that see the point of a case, the one whose pixel it is.
Seen seen_by(const CameraRays& camera, const Case& c, Vec3 point, const SampleKey& key) {
    std::array<Seen, 2> seen;
    const int count = camera.seen(point, key.two(0, Purpose::lens), c.lambda_nm, seen);
    for (int i = 0; i < count; ++i) {
        const PixelRect& frame = seen[std::size_t(i)].frame;
        if (c.x >= frame.x0 && c.x < frame.x1 && c.y >= frame.y0 && c.y < frame.y1)
            return seen[std::size_t(i)];
    }
    ADD_FAILURE() << "not seen";
    return {};
}

TEST(CameraView, APointOnARayIsSeenWhereTheRayBegan) {
    for (const test_kit::CameraKind& kind : test_kit::cameras_of_all_kinds(fine_film())) {
        SCOPED_TRACE(kind.name);
        const CameraRays camera(kind.scene);
        for (const Case& c : kCases) {
            const SampleKey key(stream_key(7, std::uint32_t(c.x), std::uint32_t(c.y)), 5);
            const Ray ray = ray_of(camera, c.x, c.y, key, c.lambda_nm);
            const Seen seen = seen_by(camera, c, ray.origin + ray.direction * c.distance, key);
            EXPECT_NEAR(seen.x, c.x + 0.5, kPlace);
            EXPECT_NEAR(seen.y, c.y + 0.5, kPlace);
            EXPECT_NEAR(seen.distance, c.distance, kRounding * (10.0 + c.distance));
            EXPECT_LT(length(seen.direction + ray.direction),
                      kRounding * (10.0 + 1.0 / c.distance));
        }
    }
}

/// Where the ray meets the plane through `point` across `normal`.
Vec3 met(const Ray& ray, Vec3 point, Vec3 normal) {
    return ray.origin +
           ray.direction * (dot(point - ray.origin, normal) / dot(ray.direction, normal));
}

TEST(CameraView, PixelsPerAreaAreTheDerivativesOfRays) {
    for (const test_kit::CameraKind& kind : test_kit::cameras_of_all_kinds(fine_film())) {
        SCOPED_TRACE(kind.name);
        const CameraRays camera(kind.scene);
        for (const Case& c : kCases) {
            // The same key: the same point of the lens.
            const SampleKey key(stream_key(7, 1, 2), std::uint32_t(c.x));
            const Ray ray = ray_of(camera, c.x, c.y, key, c.lambda_nm);
            const Vec3 point = ray.origin + ray.direction * c.distance;
            const auto at = [&](int x, int y) {
                return met(ray_of(camera, x, y, key, c.lambda_nm), point, ray.direction);
            };
            // Within one eye's picture.
            const int dx = c.x == 999 || c.x == 1996 ? -1 : 1;
            const int dy = c.y == 499 || c.y == 998 ? -1 : 1;
            const auto derivative = [&](int sx, int sy) {
                return (at(c.x + sx, c.y + sy) * 4.0 - at(c.x + 2 * sx, c.y + 2 * sy) -
                        point * 3.0) *
                       0.5;
            };
            const Vec3 across = derivative(dx, 0), down = derivative(0, dy);
            const double area = length(cross(across, down));
            EXPECT_NEAR(seen_by(camera, c, point, key).pixels_per_m2 * area, 1.0, kDifferences);
            EXPECT_DOUBLE_EQ(seen_by(camera, c, point, key).pixels_per_m2,
                             camera.pixels_per_m2(ray.origin, point));
        }
    }
}

TEST(CameraView, SeesNothingBehindOrOutsideOfThePicture) {
    std::array<Seen, 2> seen;
    for (const test_kit::CameraKind& kind : test_kit::cameras_of_all_kinds(fine_film())) {
        SCOPED_TRACE(kind.name);
        const CameraRays camera(kind.scene);
        const bool around = std::holds_alternative<Panorama>(kind.scene.camera.projection);
        const Vec3 behind = camera.position() - camera.axis() * 3.0;
        EXPECT_EQ(camera.seen(behind, {0.3, 0.6}, 550.0, seen), around ? 1 : 0);
        const Vec3 aside = camera.position() + camera.axis() * 0.1 + Vec3{0, 50, 0};
        EXPECT_EQ(camera.seen(aside, {0.3, 0.6}, 550.0, seen), around ? 1 : 0);
    }
}

}  // namespace
}  // namespace dewbow
