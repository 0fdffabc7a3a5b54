// SPDX-License-Identifier: Apache-2.0

// The paper's rainbow in pictures, against eq. 14 by hand:
//     L' = L (1 − r) + F r,   r = 1 − e^(−h d / t),
// in each channel, for what is seen straight, by mirrors and through glass.

#include <gtest/gtest.h>

#include "dewbow/spectrum/rgb.h"
#include "kit_of_1989.h"
#include "pictures.h"

namespace dewbow {
namespace {

using namespace kit;

/// What is behind the fog, over the film's white.
constexpr double kBehind = 0.3;
constexpr double kFogPerMetre = 1e-3, kDepth = 800.0;
/// Packets of 16 stratified wavelengths over 64 samples: 3e-3 of smooth spectra.
constexpr double kQuadrature = 5e-3;
/// The monitor's white is sRGB's (.3127, .3290), which D65 itself misses by 2e-5.
constexpr double kWhites = 5e-4;

/// A sun behind one who looks along −z, level, and nothing but an even sky.
Scene scene_with(const PaperRainbow& rainbow) {
    Scene scene = scene_of_tests(1, 1, 8);
    scene.render.packet = 16;
    scene.render.samples_per_pixel = 64;
    scene.lights.push_back(DistantLight{{{0, 0, -1}}, Angle{}, make_constant(0.0)});
    scene.lights.push_back(UniformEnvironment{make_scaled(film_white(), kBehind)});
    scene.camera.projection = Perspective{1e-3 * deg};
    scene.paper_rainbow = rainbow;
    scene.paper_rainbow->constant = kFogPerMetre / m;
    scene.paper_rainbow->depth = kDepth * m;
    return scene;
}

PaperRainbow rings() {
    PaperRings rings;
    rings.bow.index = ImpressionisticBow::Index::by_angle;
    PaperRainbow rainbow;
    rainbow.bow = rings;
    return rainbow;
}

PaperRainbow table() {
    PaperRainbow rainbow;
    rainbow.bow = paper_method_corrected();
    return rainbow;
}

/// `r_deg` above the antisolar point.
Vec3 sight(double r_deg) { return {0.0, sin(r_deg * deg), -cos(r_deg * deg)}; }

void look_along(Scene& scene, Vec3 direction) {
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 0, 0}, direction, {1, 0, 0}));
}

Colour<LinearSrgb> seen(const Scene& scene, const char* estimator) {
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *method(estimator)(scene), options, film);
    return rgb_from_xyz<LinearSrgb>(film.xyz(0, 0));
}

void expect_near(Colour<LinearSrgb> found, Colour<LinearSrgb> expected, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << c;
}

/// Of light over white, behind `distance` metres of fog of these colours and transmittances.
Colour<LinearSrgb> behind_fog(Colour<LinearSrgb> colour, Colour<LinearSrgb> transmittance,
                              double distance, double behind = kBehind) {
    Colour<LinearSrgb> left;
    for (int c = 0; c < 3; ++c) {
        const double r = 1.0 - std::exp(-kFogPerMetre * distance / transmittance[c]);
        left[c] = behind * (1.0 - r) + colour[c] * r;
    }
    return left;
}

constexpr Colour<LinearSrgb> kOnes{{1.0, 1.0, 1.0}};

TEST(PaperRainbow, RingsReplaceWhatIsBehindThem) {
    Scene scene = scene_with(rings());
    const auto colours = linear_spectrum_samples();
    for (const int ring : {0, 3, 6, 9, 12}) {
        look_along(scene, sight(43.0 - (ring + 0.5) * 2.0 / kPaperSamples));
        expect_near(seen(scene, "path"), behind_fog(colours[std::size_t(ring)], kOnes, kDepth),
                    kQuadrature);
    }
    look_along(scene, sight(44.0));
    expect_near(seen(scene, "path"), kOnes * kBehind, kQuadrature);
}

TEST(PaperRainbow, TableReplacesChannelsAtTheirOwnRates) {
    Scene scene = scene_with(table());
    const FogTable fogs = make_fog_table(paper_method_corrected());
    for (const double r_deg : {20.05, 40.85, 42.05, 51.05, 100.05}) {
        look_along(scene, sight(r_deg));
        expect_near(seen(scene, "path"),
                    behind_fog(kOnes, fogs.transmittance[std::size_t(10.0 * r_deg)], kDepth),
                    kQuadrature);
    }
}

// Fog is as deep as what is seen is far, on the way to a mirror and on the way from there.
TEST(PaperRainbow, StandsInMirrors) {
    Scene scene = scene_with(rings());
    constexpr double kMirror = 300.0;
    add(scene, Rectangle{10.0 * m, 10.0 * m}, {"mirror", Mirror{make_constant(1.0)}},
        translation(sight(42.0) * -kMirror) * rotation({1, 0, 0}, 42.0 * deg));
    look_along(scene, sight(42.0) * -1.0);  // away from the bow, and back towards it
    const auto colour = linear_spectrum_samples()[6];
    expect_near(seen(scene, "path"), behind_fog(colour, kOnes, kDepth), kQuadrature);
    // A mirror before the bow: the fog of its distance, and what it shows has none.
    scene.shapes.front().world_from_object = Transform<World, Object>(
        translation(sight(42.0) * kMirror) * rotation({1, 0, 0}, 42.0 * deg));
    look_along(scene, sight(42.0));
    expect_near(seen(scene, "path"), behind_fog(colour, kOnes, kMirror), kQuadrature);
}

TEST(PaperRainbow, IsNotInsideBodies) {
    Scene scene = scene_with(rings());
    scene.lights.pop_back();
    add(scene, Sphere{1000.0 * m}, lamp(make_scaled(film_white(), kBehind), true));
    look_along(scene, sight(42.0));
    expect_near(seen(scene, "path"), behind_fog(linear_spectrum_samples()[6], kOnes, kDepth),
                kQuadrature);
    add(scene, Sphere{2000.0 * m}, dielectric(plain(1.0)));  // all of it
    for (const char* estimator : {"path", "distributed_1989"})
        expect_near(seen(scene, estimator), kOnes * kBehind, kQuadrature);
}

TEST(PaperRainbow, LightsNoMattSurface) {
    constexpr double kReflectance = 0.5;
    Scene scene = scene_with(rings());
    add(scene, Rectangle{1.0 * m, 1.0 * m}, diffuse(kReflectance), translation({0, 0, 1}));
    look_along(scene, {0, 0, 1});  // at a card that faces the bow
    expect_near(seen(scene, "path"), kOnes * (kReflectance * kBehind), kQuadrature);
}

TEST(PaperRainbow, IsTheSameByTheMethodOf1989) {
    for (const auto transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral})
        for (const bool by_table : {false, true}) {
            Scene scene = scene_with(by_table ? table() : rings());
            auto& settings = scene.render.distributed_1989;
            settings.transport = transport;
            settings.model.colours = SpectralColours::cie;
            settings.model.monitor = "srgb";
            // The bands' quadrature of white and of colours.
            const double tolerance = transport == RgbOrSpectral::rgb ? kWhites : 2e-3;
            const FogTable fogs = make_fog_table(paper_method_corrected());
            const double r_deg = 41.05;
            look_along(scene, sight(r_deg));
            const auto expected =
                by_table ? behind_fog(kOnes, fogs.transmittance[std::size_t(10.0 * r_deg)], kDepth)
                         : behind_fog(linear_spectrum_samples()[12], kOnes, kDepth);
            expect_near(seen(scene, "distributed_1989"), expected, tolerance);
        }
}

// E10: as printed everything is replaced from the eye on, and then more: what is behind is taken
// away more than once, and the film of 1989 has its negative.
TEST(PaperRainbow, AsPrintedReplacesMoreThanAll) {
    PaperRainbow rainbow = rings();
    rainbow.equation = FogEquation::printed;
    Scene scene = scene_with(rainbow);
    look_along(scene, sight(42.0));
    const auto colour = linear_spectrum_samples()[6];
    const double r = std::exp(kFogPerMetre * kDepth);
    scene.render.distributed_1989.model.monitor = "srgb";
    expect_near(seen(scene, "distributed_1989"), kOnes * (kBehind * (1.0 - r)) + colour * r,
                kWhites);
    expect_near(seen(scene, "path"), colour * r, kQuadrature * r);
}

// The bow is infinitely far away for both eyes: in each picture it stands where the same
// directions are.
TEST(PaperRainbow, EachEyeHasItsOwn) {
    Scene scene = scene_with(table());
    scene.film.width = 128, scene.film.height = 8;
    scene.render.samples_per_pixel = 1;
    scene.film.filter = {FilterKind::box, 1e-9};
    scene.camera.projection = Perspective{0.5 * deg};
    scene.camera.stereo = StereoPair{0.1 * m, 5.0 * m, StereoLayout::side_by_side};
    // The bow upright through the middle of the picture.
    scene.camera.world_from_camera = Transform<World, Camera>(
        looking_at({0, 0, 0}, {sin(41.6 * deg), 0.0, -cos(41.6 * deg)}, {0, 1, 0}));
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_distributed_1989_estimator(scene), options, film);
    const CameraRays camera(scene);
    const FogTable fogs = make_fog_table(paper_method_corrected());
    int differ = 0;
    for (int x = 0; x < film.width(); ++x) {
        const Vec3 direction = camera.ray_through(x + 0.5, 4.5).direction;
        const auto bucket = std::size_t(std::acos(dot(direction, {0, 0, -1})) * 180.0 / kPi * 10.0);
        const auto expected = behind_fog(kOnes, fogs.transmittance[bucket], kDepth);
        const auto found = rgb_from_xyz<LinearSrgb>(film.xyz(x, 4));
        differ += std::abs(found[1] - expected[1]) > 0.02;
    }
    EXPECT_EQ(differ, 0);
}

}  // namespace
}  // namespace dewbow
