// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/thin_lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/optics/catalogue.h"
#include "dewbow/render/camera_ray.h"

namespace dewbow {
namespace {

using unit::m;

constexpr double kPi = std::numbers::pi;
/// A few roundings of numbers near 1.
constexpr double kRounding = 1e-12;
/// A grid of 360 × 360 midpoints, as many in each wedge, over an integrand that is folded
/// once: 1.4e-3 of a wedge between two points.
constexpr double kGrid = 1e-4;
constexpr int kSide = 360;

TEST(ThinLens, PolygonsAreEvenlyFilled) {
    for (const int corners : {3, 4, 5, 6, 9}) {
        double x = 0.0, y = 0.0, squares = 0.0, highest = 0.0;
        const double apothem = std::cos(kPi / corners);
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                const DiscPoint p = sample_polygon(corners, (i + 0.5) / kSide, (j + 0.5) / kSide);
                x += p.x, y += p.y, squares += p.x * p.x + p.y * p.y;
                highest = std::max(highest, p.y);
                for (int edge = 0; edge < corners; ++edge) {
                    const double normal = kPi * (0.5 + (2.0 * edge + 1.0) / corners);
                    ASSERT_LE(p.x * std::cos(normal) + p.y * std::sin(normal), apothem + kRounding);
                }
            }
        }
        const double count = double(kSide) * kSide;
        EXPECT_NEAR(x / count, 0.0, 10.0 * kGrid) << corners;  // wedges are cut by the grid
        EXPECT_NEAR(y / count, 0.0, 10.0 * kGrid) << corners;
        // The polar moment of a regular polygon over its area.
        EXPECT_NEAR(squares / count, (2.0 + std::cos(2.0 * kPi / corners)) / 6.0, 10.0 * kGrid)
            << corners;
        EXPECT_NEAR(highest, 1.0, 0.05) << corners;  // a corner is up
    }
}

ThinLens flint_lens() {
    ThinLens lens;
    lens.aperture_radius = 0.02 * m;
    lens.focus_distance = 3.0 * m;
    lens.glass = LensGlass{make_dispersion(find_glass("schott/N-SF11").data), 0.1 * m};
    return lens;
}

/// Where a film at the d line's image distance is in focus, by the lens maker's formula and Gauss's
/// equation, step by step.
double focus_by_gauss(double lambda_nm) {
    const auto n = [](double nm) {
        const auto glass = make_dispersion(find_glass("schott/N-SF11").data);
        return (*glass)(nm * unit::nm).value / (*air())(nm * unit::nm).value;
    };
    const double f_d = 0.1, s_d = 3.0;
    const double film = f_d * s_d / (s_d - f_d);
    const double power = (n(lambda_nm) - 1.0) / (f_d * (n(kLined.to(unit::nm)) - 1.0));
    return 1.0 / (power - 1.0 / film);
}

TEST(ThinLens, EachWavelengthHasItsFocus) {
    const ThinLensOptics optics(flint_lens());
    ASSERT_TRUE(optics.disperses());
    const std::array<double, 5> lambda_nm = {420.0, 486.1327, kLined.to(unit::nm), 656.2725, 780.0};
    std::array<double, 5> vergence;
    optics.vergences(lambda_nm, vergence);
    for (std::size_t i = 0; i < lambda_nm.size(); ++i)
        EXPECT_NEAR(vergence[i] * focus_by_gauss(lambda_nm[i]), 1.0, 1e-11) << lambda_nm[i];
    EXPECT_NEAR(vergence[2], 1.0 / 3.0, kRounding);
    EXPECT_GT(vergence[0], vergence[1]);  // blue focuses nearer
    // The spread over F and C is the power over the Abbe number (25.68): 10 m⁻¹ / 25.68.
    EXPECT_NEAR(vergence[1] - vergence[3], 10.0 / 25.68, 1e-3);
}

TEST(ThinLens, GlassWithoutDispersionIsNone) {
    ThinLens lens = flint_lens();
    lens.glass->index = make_dispersion({"constant", {1.5}, IndexReference::air});
    EXPECT_FALSE(ThinLensOptics(lens).disperses());
    lens.glass.reset();
    EXPECT_FALSE(ThinLensOptics(lens).disperses());
}

Scene scene_with(const ThinLens& lens) {
    Scene scene = make_empty_scene();
    scene.film.width = 40, scene.film.height = 20;
    scene.film.filter = {FilterKind::box, 1e-9};  // pixel centres
    scene.camera.projection = Perspective{40.0 * unit::deg};
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({1, 2, 3}, {0, 1, -4}, {0, 1, 0}));
    scene.camera.lens = lens;
    return scene;
}

// All rays of a pixel meet where the chief ray meets the plane of focus: at each wavelength its
// own.
TEST(ThinLens, RaysOfAPixelMeetInFocus) {
    const CameraRays camera(scene_with(flint_lens()));
    ASSERT_TRUE(camera.disperses());
    const std::array<double, 3> lambda_nm = {450.0, kLined.to(unit::nm), 700.0};
    const Ray chief = camera.ray_through(4.5, 15.5);
    double widest = 0.0;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const SampleKey key(stream_key(0, 4, 15), i);
        const RayLanes rays = camera.rays(4, 15, key, lambda_nm);
        ASSERT_EQ(rays.count, 3);
        for (int k = 0; k < 3; ++k) {
            const double depth = focus_by_gauss(lambda_nm[std::size_t(k)]);
            const Vec3 meeting =
                chief.origin + chief.direction * (depth / dot(chief.direction, camera.axis()));
            const Vec3 to = meeting - rays.origin(k);
            const double miss = length(to - rays.direction(k) * dot(to, rays.direction(k)));
            EXPECT_LT(miss, 1e-7) << lambda_nm[std::size_t(k)];  // the filter's 1e-9 px at 3 m
            const Vec3 offset = rays.origin(k) - camera.position();
            EXPECT_NEAR(dot(offset, camera.axis()), 0.0, kRounding);
            EXPECT_EQ(rays.origin(k), rays.origin(0));
            widest = std::max(widest, length(offset));
        }
        // The ray for the layers is that of the d line.
        const Ray ray = camera.ray(4, 15, key);
        EXPECT_LT(length(ray.direction - rays.direction(1)), kRounding);
    }
    EXPECT_LE(widest, 0.02 + kRounding);
    EXPECT_GT(widest, 0.018);
}

}  // namespace
}  // namespace dewbow
