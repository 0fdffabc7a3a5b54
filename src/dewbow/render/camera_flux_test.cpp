// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/render/camera_kinds.h"
#include "dewbow/render/camera_ray.h"

namespace dewbow {
namespace {

// A glowing screen is rendered in two ways: by rays from the camera that look where they arrive,
// and by points of the screen that are seen by the film. The first knows nothing of seen(), of its
// density, or of which pixels a point counts for.

constexpr int kWidth = 12, kHeight = 8;
constexpr std::uint32_t kPoints = 1u << 16, kRays = 1u << 8;
constexpr double kLambda_nm = 430.0;

/// A flat screen across the line of sight, or a sphere around the camera.
class Screen {
public:
    Screen(const Scene& scene) : camera_(scene) {
        if (std::holds_alternative<Panorama>(scene.camera.projection)) return;
        // Not square to the line of sight, and as wide as any ray of any filter and lens reaches.
        const Vec3 middle = camera_.position() + camera_.axis() * 2.5;
        const Tangents frame = tangents_of(normalised(camera_.axis() + Vec3{0.1, 0.2, 0.05}));
        flat_ = true;
        corner_ = middle, across_ = frame.t, up_ = frame.b;
        Bounds reach;  // along both, m
        const double beyond = scene.film.filter.radius;
        for (const double x : {-beyond, kWidth + beyond})
            for (const double y : {-beyond, kHeight + beyond}) {
                const Vec3 p = hit(camera_.ray_through(x, y)) - middle;
                reach.add({dot(p, across_), dot(p, up_), 0.0});
            }
        const double margin = 0.3;
        corner_ += across_ * (reach.low.x - margin) + up_ * (reach.low.y - margin);
        across_ *= reach.high.x - reach.low.x + 2.0 * margin;
        up_ *= reach.high.y - reach.low.y + 2.0 * margin;
    }
    struct Place {
        Vec3 point, normal;
        double area;  ///< of all of it
    };
    Place at(double u, double v) const {
        if (flat_) {
            const Vec3 normal = cross(across_, up_);
            return {corner_ + across_ * u + up_ * v, normalised(normal), length(normal)};
        }
        const Vec3 outwards = sample_uniform_sphere<World>(u, v).v;
        return {camera_.position() + outwards * kRadius, outwards,
                4.0 * std::numbers::pi * kRadius * kRadius};
    }
    Vec3 hit(const Ray& ray) const {
        if (!flat_) return ray.origin + ray.direction * kRadius;
        const Vec3 normal = cross(across_, up_);
        return ray.origin +
               ray.direction * (dot(corner_ - ray.origin, normal) / dot(ray.direction, normal));
    }

private:
    static constexpr double kRadius = 1.5;
    CameraRays camera_;
    bool flat_ = false;
    Vec3 corner_, across_, up_;
};

using Picture = std::vector<double>;
using Glow = std::function<double(Vec3 point)>;

Picture by_points(const CameraRays& camera, const Screen& screen, const Glow& glow) {
    Picture picture(kWidth * kHeight);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const SampleKey key(stream_key(3, 0, 0), i);
        const auto u = key.two(0, Purpose::light_point);
        const Screen::Place place = screen.at(u[0], u[1]);
        std::array<Seen, 2> seen;
        const int count = camera.seen(place.point, key.two(0, Purpose::lens), kLambda_nm, seen);
        for (int k = 0; k < count; ++k) {
            const Seen& eye = seen[std::size_t(k)];
            const double value = glow(place.point) * place.area / kPoints * eye.pixels_per_m2 *
                                 std::abs(dot(eye.direction, place.normal));
            camera.for_each_pixel(eye, [&](int x, int y, double weight) {
                picture[std::size_t(y * kWidth + x)] += value * weight;
            });
        }
    }
    return picture;
}

Picture by_rays(const CameraRays& camera, const Screen& screen, const Glow& glow) {
    Picture picture(kWidth * kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (std::uint32_t i = 0; i < kRays; ++i) {
                const SampleKey key(stream_key(5, std::uint32_t(x), std::uint32_t(y)), i);
                const Ray ray = camera.disperses() ? camera.rays(x, y, key, {&kLambda_nm, 1}).ray(0)
                                                   : camera.ray(x, y, key);
                picture[std::size_t(y * kWidth + x)] += glow(screen.hit(ray)) / kRays;
            }
    return picture;
}

double mean_of_border(const Picture& picture) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            if (x == 0 || y == 0 || x == kWidth - 1 || y == kHeight - 1)
                sum += picture[std::size_t(y * kWidth + x)], ++count;
    return sum / count;
}

/// The points are fixed numbers. Of a pixel of a box filter there are about 500, so that a point
/// more or less at its border is what differs, and more behind a lens; beside a pole pixels per
/// area are many and unequal.
constexpr double kPixel = 0.1, kPixelAtPole = 0.15, kBorder = 0.01;
/// Where only some pixels hold light, there are fewer points whose chance matters.
constexpr double kPixelOfSpot = 0.07;

/// @param pixel_at_pole  tolerance in the first and last row
void expect_equal(const Picture& a, const Picture& b, double pixel, double pixel_at_pole) {
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto i = std::size_t(y * kWidth + x);
            const bool pole = y == 0 || y == kHeight - 1;
            EXPECT_NEAR(a[i], b[i], pole ? pixel_at_pole : pixel) << x << " " << y;
        }
    EXPECT_NEAR(mean_of_border(a), mean_of_border(b), kBorder);
}

bool has_poles(const Scene& scene) {
    return std::holds_alternative<Panorama>(scene.camera.projection);
}

Film film_with(PixelFilter filter) {
    Film film;
    film.width = kWidth;
    film.height = kHeight;
    film.filter = filter;
    return film;
}

constexpr PixelFilter kFilters[] = {
    {FilterKind::box, 0.5}, {FilterKind::box, 2.0}, {FilterKind::blackman_harris, 1.5}};

// Every pixel of an even screen is as bright as it is: at the border, where eyes or the edges of a
// panorama meet, and at its poles.
TEST(CameraFlux, AnEvenScreenIsEven) {
    for (const PixelFilter& filter : kFilters)
        for (const auto& kind : test_kit::cameras_of_all_kinds(film_with(filter))) {
            SCOPED_TRACE(kind.name);
            expect_equal(
                by_points(CameraRays(kind.scene), Screen(kind.scene), [](Vec3) { return 1.0; }),
                Picture(kWidth * kHeight, 1.0), kPixel,
                has_poles(kind.scene) ? kPixelAtPole : kPixel);
        }
}

// The light lies near the lower edge: filters of a panorama reach it over the pole.
TEST(CameraFlux, PointsBringThePictureOfRays) {
    for (const PixelFilter& filter : kFilters)
        for (const auto& kind : test_kit::cameras_of_all_kinds(film_with(filter))) {
            SCOPED_TRACE(kind.name);
            const CameraRays camera(kind.scene);
            const Screen screen(kind.scene);
            const Vec3 centre = screen.hit(camera.ray_through(1.0, 6.5));
            const Glow glow = [&](Vec3 p) { return std::exp(-dot(p - centre, p - centre) / 0.25); };
            expect_equal(by_points(camera, screen, glow), by_rays(camera, screen, glow),
                         kPixelOfSpot, kPixelOfSpot);
        }
}

}  // namespace
}  // namespace dewbow
