// SPDX-License-Identifier: Apache-2.0

// Where bows stand in a picture, and how bright they are there.
//
// The sun stands on the horizon behind the camera; before the camera a thin sheet of rain hangs
// across the way to the antisolar point, so that radiance over 1 / cos of the angle from that point
// is the phase function, but for τ = 1e-4. Angles belong to pixels by projections written here once
// more.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "dewbow/math/transform.h"
#include "dewbow/rainbow/scattering_table.h"
#include "dewbow/render/session.h"
#include "dewbow/sky/test_drops.h"
#include "dewbow/spectrum/cie.h"
#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

/// Of angles, a tenth of the sun's disc; of brightness, about the least step that an eye sees.
constexpr double kPlace_deg = 0.05, kRatio = 0.02;
constexpr double kSheet_m = 10.0, kDepth = 1e-4;

using Profile = std::vector<std::pair<double, std::array<double, 3>>>;  ///< by angle in degrees

DropCloudRequest request_of(const char* model, const char* sizes) {
    DropCloudRequest request = test_drops(kDepth / kSheet_m, sizes, model);
    request.discs = {SunDisc{}};
    return request;
}

Scene scene_of(DropCloudPtr drops) {
    Scene scene = empty_scene();
    const ConvexRegion sheet({{{0.0, 0.0, 1.0}, -50.0}, {{0.0, 0.0, -1.0}, 50.0 + kSheet_m}});
    scene.rains.push_back({"sheet", sheet, std::move(drops), std::nullopt});
    scene.lights.push_back(DistantLight{{{0.0, 0.0, -1.0}}, kSunRadius, make_constant(1.0)});
    scene.film.filter = {FilterKind::box, 1e-9};  // the centres of pixels
    scene.render.samples_per_pixel = 16;
    scene.render.packet = 16;
    return scene;
}

FilmSums rendered(const Scene& scene) {
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_path_estimator(scene), options, film);
    return film;
}

/// The middle column of a picture, over what the sheet's slant does.
/// @param angle_rad  from the antisolar point, upwards, by the height in the picture.
Profile column_of(const Scene& scene, const std::function<double(double)>& angle_rad) {
    const FilmSums film = rendered(scene);
    Profile profile;
    for (int y = film.height() - 1; y >= 0; --y) {
        const double angle = angle_rad(y + 0.5);
        const auto xyz = film.xyz(scene.film.width / 2, y);
        profile.push_back({angle * 180.0 / kPi, {}});
        for (int c = 0; c < 3; ++c)
            profile.back().second[std::size_t(c)] = xyz[c] * std::cos(angle);
    }
    return profile;
}

/// A camera that is raised by `pitch_deg` from the antisolar point.
Profile perspective(Scene scene, double fov_deg, double pitch_deg, int height) {
    const double pitch = pitch_deg * kPi / 180.0, half = std::tan(0.5 * fov_deg * kPi / 180.0);
    scene.camera.projection = Perspective{fov_deg * deg};
    scene.camera.world_from_camera = Transform<World, Camera>(
        looking_at({}, {0.0, std::sin(pitch), -std::cos(pitch)}, {0.0, 1.0, 0.0}));
    scene.film.width = 3, scene.film.height = height;
    return column_of(scene,
                     [=](double y) { return pitch + std::atan(half * (1.0 - 2.0 * y / height)); });
}

Profile panorama(Scene scene, int height) {
    scene.camera.projection = Panorama{};
    scene.film.width = 3, scene.film.height = height;
    return column_of(scene, [=](double y) { return kPi * (0.5 - y / height); });
}

/// The same of the table, without a picture: equal-energy light, colour by the trapezoid rule.
Profile table_of(const DropCloudRequest& drops) {
    TableRequest request;
    request.model = drops.model;
    request.sizes = drops.showers.front();
    request.optics = drops.optics;
    constexpr double kStep_nm = 2.0;
    for (double nm = 380.0; nm <= 780.0; nm += kStep_nm)
        request.wavelengths.push_back(nm * unit::nm);
    for (double theta = 124.0; theta <= 144.0; theta += 0.02) request.angles.push_back(theta * deg);
    const ScatteringTable table = make_scattering_table(request);
    Profile profile;
    for (std::size_t a = request.angles.size(); a-- > 0;) {
        profile.push_back({180.0 - request.angles[a].to(deg), {}});
        for (std::size_t j = 0; j < request.wavelengths.size(); ++j) {
            const auto bar = cie_xyz_bar(request.wavelengths[j].to(unit::nm));
            for (std::size_t c = 0; c < 3; ++c)
                profile.back().second[c] += kStep_nm * bar[c] * table.at(a, j).unpolarised();
        }
    }
    return profile;
}

struct Peak {
    double angle_deg = 0.0, height = 0.0;
};
/// Between two angles: the summit of a parabola through what is above 0.9 of the brightest.
Peak peak_of(const Profile& profile, std::size_t channel, double from_deg, double to_deg) {
    double most = 0.0, at = 0.0;
    for (const auto& [angle, xyz] : profile)
        if (angle > from_deg && angle < to_deg && xyz[channel] > most)
            most = xyz[channel], at = angle;
    // Least squares of c + b t + a t² with t around the brightest.
    double s[5] = {}, r[3] = {};
    for (const auto& [angle, xyz] : profile) {
        const double t = angle - at;
        if (std::abs(t) > 1.0 || xyz[channel] < 0.9 * most) continue;
        for (int k = 0; k < 5; ++k) s[k] += std::pow(t, k);
        for (int k = 0; k < 3; ++k) r[k] += std::pow(t, k) * xyz[channel];
    }
    const auto det = [](std::array<Vec3, 3> m) { return dot(m[0], cross(m[1], m[2])); };
    const Vec3 c0{s[0], s[1], s[2]}, c1{s[1], s[2], s[3]}, c2{s[2], s[3], s[4]},
        rhs{r[0], r[1], r[2]};
    const double d = det({c0, c1, c2});
    const double c = det({rhs, c1, c2}) / d, b = det({c0, rhs, c2}) / d, a = det({c0, c1, rhs}) / d;
    const double t = -b / (2.0 * a);
    return {at + t, c + t * (b + a * t)};
}

struct Bow {
    double from_deg, to_deg;
};
constexpr Bow kPrimary{38.0, 44.0}, kSecondary{49.0, 55.0};

/// The largest distance of peaks in X, Y and Z of both bows from those of the table.
double misplaced_deg(const Profile& picture, const Profile& table) {
    double most = 0.0;
    for (const Bow& bow : {kPrimary, kSecondary})
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(peak_of(picture, c, bow.from_deg, bow.to_deg).angle_deg -
                                           peak_of(table, c, bow.from_deg, bow.to_deg).angle_deg));
    return most;
}

TEST(BowAngles, StandWhereTheTableSays) {
    const DropCloudRequest request = request_of("auto", "normal:mean=0.5mm,width=10%");
    const Profile table = table_of(request);
    const Scene scene = scene_of(make_drop_cloud(request));
    EXPECT_LT(misplaced_deg(perspective(scene, 24.0, 47.0, 400), table), kPlace_deg);
    EXPECT_LT(misplaced_deg(perspective(scene, 60.0, 40.0, 1200), table), kPlace_deg);
    EXPECT_LT(misplaced_deg(perspective(scene, 110.0, 25.0, 2400), table), kPlace_deg);
    EXPECT_LT(misplaced_deg(panorama(scene, 3600), table), kPlace_deg);
}

// A sun that stands 0.1° higher is found: the measure is no blunter than what is asked of it.
TEST(BowAngles, SeeASunThatIsMoved) {
    const DropCloudRequest request = request_of("descartes", "0.5mm");
    const Profile table = table_of(request);
    Scene scene = scene_of(make_drop_cloud(request));
    EXPECT_LT(misplaced_deg(perspective(scene, 24.0, 47.0, 400), table), kPlace_deg);
    const double moved = 0.1 * kPi / 180.0;
    std::get<DistantLight>(scene.lights.front()).direction = {
        {0.0, -std::sin(moved), -std::cos(moved)}};
    EXPECT_NEAR(misplaced_deg(perspective(scene, 24.0, 47.0, 400), table), 0.1, kPlace_deg);
}

// By ray optics, for water of 20 °C in air, a sun's disc of 0.533°, the orders that make the two
// bows, equal-energy light and a black sky: luminance is greatest 41.78° and 51.43° from the
// antisolar point, and 7.59 times as great at the first. (At n = 1.334, near 560 nm, the least
// turned rays come at 41.93° and 51.15°; the disc moves the greatest luminance to the bright sides
// of these edges. Light of all orders together makes the ratio 6.75: it is reflected outside the
// drops, and the bow of order 6 lies in the secondary.)
TEST(BowAngles, AreDescartesAnglesInEqualEnergyLight) {
    DropCloudRequest request = request_of("descartes", "0.5mm");
    request.orders = {2, 3};
    const Scene scene = scene_of(make_drop_cloud(request));
    const Profile picture = perspective(scene, 24.0, 47.0, 600);
    const Peak primary = peak_of(picture, 1, kPrimary.from_deg, kPrimary.to_deg);
    const Peak secondary = peak_of(picture, 1, kSecondary.from_deg, kSecondary.to_deg);
    EXPECT_NEAR(primary.angle_deg, 41.78, kPlace_deg);
    EXPECT_NEAR(secondary.angle_deg, 51.43, kPlace_deg);
    EXPECT_NEAR(primary.height / secondary.height / 7.59, 1.0, kRatio);
}

/// Of the bow's light in the one pixel of a picture, 42° above the antisolar point, at its lanes.
std::vector<double> behind_polariser(Scene scene, std::optional<Angle> axis) {
    const double up = 42.0 * kPi / 180.0;
    scene.camera.world_from_camera = Transform<World, Camera>(
        looking_at({}, {0.0, std::sin(up), -std::cos(up)}, {0.0, 1.0, 0.0}));
    scene.camera.projection = Perspective{0.01 * deg};
    scene.camera.polariser = axis;
    scene.film.width = scene.film.height = 1;
    const PreparedScene prepared(scene);
    const PixelSample sample = trace_pixel_sample(prepared, 0, 0, 0);
    return {sample.radiance.begin(), sample.radiance.begin() + scene.render.packet};
}

// At the top of a bow the perpendicular light is level. A polariser on its side lets that through,
// an upright one the parallel light, and between both all is 1/2 (I⊥ cos² + I∥ sin²).
TEST(BowAngles, APolariserTakesItsShareOfTheBow) {
    constexpr double kFloat = 1e-5;  // tables of floats
    Scene scene = scene_of(make_drop_cloud(request_of("descartes", "0.5mm")));
    const std::vector<double> all = behind_polariser(scene, std::nullopt);
    const std::vector<double> upright = behind_polariser(scene, 0.0 * deg),
                              level = behind_polariser(scene, 90.0 * deg),
                              slanted = behind_polariser(scene, 30.0 * deg);
    double darkest = 1.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_NEAR((upright[k] + level[k]) / all[k], 1.0, kFloat);
        EXPECT_NEAR(slanted[k] / (0.75 * upright[k] + 0.25 * level[k]), 1.0, kFloat);
        darkest = std::min(darkest, upright[k] / level[k]);
    }
    // In the primary by rays (1 − 0.962) / 0.962 of it is left; where orders mix, a little more.
    EXPECT_GT(darkest, 0.038);
    EXPECT_LT(darkest, 0.06);
    // What is no bow is halved.
    scene.rains.clear();
    scene.lights = {UniformEnvironment{make_constant(1.0)}};
    for (const double radiance : behind_polariser(scene, 30.0 * deg)) EXPECT_EQ(radiance, 0.5);
}

}  // namespace
}  // namespace dewbow
