// SPDX-License-Identifier: Apache-2.0

// Pictures through a thin lens: how wide a small disc out of focus is at each wavelength, how
// bright it stays, and what the layers hold.

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/render/session.h"
#include "dewbow/spectrum/cie.h"
#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kBins = 8;
constexpr int kSide = 48;
constexpr double kDepth_m = 2.0, kFocus_m = 3.0, kAperture_m = 0.03, kFocal_m = 0.1;
constexpr double kDisc_m = 0.005;
constexpr double kFov_deg = 7.0;
constexpr int kSamples = 256;
/// Square of the width of a bin's picture. The disc covers 3 pixels' worth of light, so that 770 of
/// a bin's samples meet it, wherever they fall. r² over a disc is spread by 1/√3 of its mean: 2.1
/// %, here times 4.5 (false alarms: 7e-6 a bin), and 1 % for what pixels do to so small a thing.
constexpr double kSpread = 0.105;
/// The sum of a bin's picture, likewise: 1/√770 = 3.6 %, times 4.5.
constexpr double kSum = 0.16;
/// The mean of 4096 paths, in standard errors (false alarms: 7e-6).
constexpr double kSigmas = 4.5;

Scene disc_scene(bool with_glass) {
    Scene scene = empty_scene(1);
    add(scene, Disc{kDisc_m * m}, lamp(1.0), translation({0, 0, -kDepth_m}));
    scene.camera.projection = Perspective{kFov_deg * deg};
    ThinLens lens;
    lens.aperture_radius = kAperture_m * m;
    lens.focus_distance = kFocus_m * m;
    if (with_glass) lens.glass = LensGlass{glass("schott/N-SF11")->index, kFocal_m * m};
    scene.camera.lens = lens;
    scene.film.width = scene.film.height = kSide;
    scene.film.filter = {FilterKind::box, 0.5};
    scene.film.spectral_bins = kBins;
    scene.render.samples_per_pixel = kSamples;
    scene.render.wavelengths = WavelengthSampling::uniform;
    return scene;
}

double pixels_per_tangent() { return 0.5 * kSide / std::tan(0.5 * kFov_deg * kPi / 180.0); }

/// Radius in pixels of the image of a point at kDepth_m: the lens gathers its light at b', the film
/// stands at b, and the cone between is cut there. Lens maker's formula and Gauss's equation.
double blur_radius(double lambda_nm) {
    const Medium flint = *glass("schott/N-SF11");
    const Medium around{"air", air(), nullptr, 0};
    const auto n = [&](double nm) { return index_of(flint, nm) / index_of(around, nm); };
    const double f = kFocal_m * (n(kLined.to(unit::nm)) - 1.0) / (n(lambda_nm) - 1.0);
    const double film = 1.0 / (1.0 / kFocal_m - 1.0 / kFocus_m);
    const double image = 1.0 / (1.0 / f - 1.0 / kDepth_m);
    return kAperture_m * std::abs(film - image) / image / film * pixels_per_tangent();
}

struct Blob {
    double sum = 0.0, mean_square = 0.0;  ///< of the distance from the middle, in pixels
};
Blob blob(const FilmSums& film, int bin) {
    Blob result;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double value = film.bin(x, y, bin);
            result.sum += value;
            result.mean_square += value * (std::pow(x + 0.5 - 0.5 * kSide, 2.0) +
                                           std::pow(y + 0.5 - 0.5 * kSide, 2.0));
        }
    result.mean_square /= result.sum;
    return result;
}

FilmSums picture_of(const Scene& scene) {
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_path_estimator(scene), options, film);
    return film;
}

TEST(Lens, CirclesOfConfusionAreThoseOfEachWavelength) {
    const FilmSums film = picture_of(disc_scene(true));
    const double bin_nm = (kLambdaMax_nm - kLambdaMin_nm) / kBins;
    const double disc = kDisc_m / kDepth_m * pixels_per_tangent();
    double widest = 0.0, narrowest = 1e300;
    for (int bin = 0; bin < kBins; ++bin) {
        // Discs of radius r have the mean square r²/2; pixels add 1/12 along each axis.  [Sheppard]
        double expected = 0.5 * disc * disc + 2.0 / 12.0;
        for (int i = 0; i < 32; ++i)
            expected +=
                std::pow(blur_radius(kLambdaMin_nm + bin_nm * (bin + (i + 0.5) / 32)), 2.0) / 64.0;
        const Blob seen = blob(film, bin);
        EXPECT_NEAR(seen.mean_square / expected, 1.0, kSpread) << bin;
        // All light of the disc arrives, wherever it goes.
        EXPECT_NEAR(seen.sum / (kPi * disc * disc), 1.0, kSum) << bin;
        widest = std::max(widest, seen.mean_square);
        narrowest = std::min(narrowest, seen.mean_square);
    }
    EXPECT_GT(widest, 3.0 * narrowest);  // what would not show if all went one way
}

TEST(Lens, WithoutGlassAllWavelengthsAreBlurredAlike) {
    const FilmSums film = picture_of(disc_scene(false));
    const double disc = kDisc_m / kDepth_m * pixels_per_tangent();
    const double blur = blur_radius(kLined.to(unit::nm));
    const double expected = 0.5 * (disc * disc + blur * blur) + 2.0 / 12.0;
    for (int bin = 0; bin < kBins; ++bin)
        EXPECT_NEAR(blob(film, bin).mean_square / expected, 1.0, kSpread) << bin;
}

/// Radiance of one path, the mean over its lanes.
double mean_radiance(const PreparedScene& prepared, int x, std::uint32_t index) {
    const PixelSample sample = trace_pixel_sample(prepared, x, 270, index);
    double sum = 0.0;
    for (int k = 0; k < sample.wavelengths.count; ++k)
        sum += sample.radiance[std::size_t(k)] / sample.wavelengths.count;
    return sum;
}

// A lens in a room of light sees that light, at each wavelength, and a white ball as no ball.
TEST(Lens, FurnaceStaysWhite) {
    Scene scene = furnace_scene();
    scene.camera = disc_scene(true).camera;
    const PreparedScene empty(scene);
    EXPECT_EQ(mean_radiance(empty, 480, 0), 1.0);
    Scene with_ball = scene;
    add(with_ball, Sphere{0.5 * m}, diffuse(1.0), translation({0, 0, -kDepth_m}));
    const PreparedScene prepared(with_ball);
    constexpr int kPaths = 4096;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kPaths; ++i) {
        const double value = mean_radiance(prepared, 400 + i % 160, std::uint32_t(i));
        sum += value, squares += value * value;
    }
    const double mean = sum / kPaths, variance = squares / kPaths - mean * mean;
    EXPECT_NEAR(mean, 1.0, kSigmas * std::sqrt(variance / kPaths));
    EXPECT_LT(variance, 0.1);  // power: three hundredths too much or too little show
}

TEST(Lens, LayersAreThoseOfTheDLine) {
    Scene scene = furnace_scene();
    add(scene, Sphere{0.5 * m}, diffuse(0.25), translation({0, 0, -kDepth_m}));
    scene.camera = disc_scene(true).camera;
    Scene plain_lens = scene;
    plain_lens.camera.lens->glass.reset();
    const PreparedScene dispersing(scene), plainly(plain_lens);
    for (std::uint32_t i = 0; i < 16; ++i) {
        const PixelSample a = trace_pixel_sample(dispersing, 480, 100 + 20 * int(i), i);
        const PixelSample b = trace_pixel_sample(plainly, 480, 100 + 20 * int(i), i);
        EXPECT_EQ(a.hit, b.hit);
        EXPECT_EQ(a.depth, b.depth);
        EXPECT_EQ(a.normal, b.normal);
        EXPECT_EQ(a.albedo[1], b.albedo[1]);
    }
}

}  // namespace
}  // namespace dewbow
