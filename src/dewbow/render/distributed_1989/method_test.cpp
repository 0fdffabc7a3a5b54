// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/method.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/paper_index.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::distributed_1989 {
namespace {

/// Sums of 95 products.
constexpr double kRounding = 1e-12;
/// ∫ D65 x̄ȳz̄ by the trapezoid rule at 0.5 nm, for the film, against the model's white.
constexpr double kWhiteByQuadrature = 1e-6;

MediumPtr medium(const char* glass) {
    return std::make_shared<Medium>(
        Medium{glass, make_dispersion(find_glass(glass).data), nullptr, 0});
}

/// A ball of SF11 in air.
Scene ball(RgbOrSpectral transport, SpectralColours colours) {
    Scene scene = make_empty_scene();
    const int flint = scene.add({"flint", Dielectric{medium("schott/SF11")}});
    scene.shapes.push_back({"ball", Sphere{1.0 * unit::m}, {}, flint});
    scene.render.distributed_1989.transport = transport;
    scene.render.distributed_1989.model.colours = colours;
    return scene;
}

/// What a ray without wavelength makes of light.
MonitorRgb colour_of(const Method& method, const Spectrum& light) {
    Bands bands = method.make_white_bands();
    MonitorRgb sum;
    for (const BandBlock& block : bands.blocks()) {
        LaneValues radiance;
        light.eval_lanes(block.lanes.lambdas(), radiance.first(block.lanes.count));
        sum = sum + bands.sum(block, BandValues(bands.count(), 1.0), radiance);
    }
    return sum;
}

void expect_near(MonitorRgb a, MonitorRgb b, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << c;
}

TEST(Method, TheFilmsWhiteIsWhiteToRaysWithoutWavelength) {
    for (const SpectralColours colours :
         {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie}) {
        for (const double luminance : {kLuminousEfficacy * cie_y_integral(), 1.0}) {
            Scene scene = ball(RgbOrSpectral::spectral, colours);
            scene.film.white_luminance = luminance;
            const double white = luminance / (kLuminousEfficacy * cie_y_integral());
            const SpectrumPtr light = make_scaled(find_illuminant("D65"), white);
            expect_near(colour_of(Method(scene), *light), {{1, 1, 1}}, kRounding);

            scene.render.distributed_1989.transport = RgbOrSpectral::rgb;
            const Method method(scene);
            const SpectrumPtr told = channels_of_light(*light, method.sampling().model());
            expect_near(colour_of(method, *told), {{1, 1, 1}}, kWhiteByQuadrature);
        }
    }
}

TEST(Method, BandsHaveTheColoursOfTheCie) {
    // Linear between the bands: all of it. Curved: chords of 5 nm lie (h²/12) L'' above the curve
    // on average, which for a black body of 2000 K is 1e-3 of L at 440 nm, and 3e-4 at 2856 K.
    const Method method(ball(RgbOrSpectral::spectral, SpectralColours::cie));
    struct Light {
        SpectrumPtr spectrum;
        double tolerance;
    };
    for (const auto& [spectrum, tolerance] :
         {Light{make_constant(1.0), 2e-5}, Light{find_illuminant("A"), 3e-4},
          Light{find_illuminant("D65"), 2e-5}, Light{make_blackbody(2000.0 * unit::K), 1e-3}}) {
        const Colour<Xyz> expected = xyz_from_spectrum(*spectrum) * (1.0 / cie_y_integral());
        const Colour<Xyz> found = method.xyz(colour_of(method, *spectrum));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c] / expected[c], 1.0, tolerance) << c;
    }
}

TEST(Method, ASampleOfWhiteLightIsItsOwnColour) {
    for (const RgbOrSpectral transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral}) {
        const Scene scene = ball(transport, SpectralColours::linear);
        const Method method(scene);
        SpectrumPtr white = find_illuminant("D65");
        if (method.carries_rgb()) white = channels_of_light(*white, method.sampling().model());
        Bands bands = method.make_sample_bands();
        for (int k = 0; k < kPaperSamples; ++k) {
            const SpectralSample sample = method.sampling().sample(k, 0.5);
            method.set_sample(sample, bands);
            LaneValues radiance;
            BandBlock& block = bands.blocks().front();
            white->eval_lanes(block.lanes.lambdas(), radiance.first(block.lanes.count));
            expect_near(bands.sum(block, BandValues(bands.count(), 1.0), radiance), sample.rgb,
                        kWhiteByQuadrature);
        }
    }
}

TEST(Method, ASampleTakesItsPlaceBetweenBands) {
    const Method method(ball(RgbOrSpectral::spectral, SpectralColours::cie));
    BandValues beta(kMostBands);
    for (int k = 0; k < kMostBands; ++k) beta[k] = 2.0 * (kLambdaMin_nm + k * kBandStep_nm);
    for (int k = 0; k < method.sampling().sampling().samples; ++k) {
        const SpectralSample sample = method.sampling().sample(k, 0.5);
        const BandValues one = method.for_sample(beta, sample);
        ASSERT_EQ(one.count(), 1);
        EXPECT_NEAR(one[0], 2.0 * method.colour_nm(sample), 1e-9);  // linear is exact
    }
}

TEST(Method, RaysAreSplitByGlassAndNotByAir) {
    Scene scene = ball(RgbOrSpectral::rgb, SpectralColours::linear);
    const auto plain =
        std::make_shared<Medium>(Medium{"plain", make_dispersion({"constant", {1.5}}), nullptr, 1});
    scene.add({"plain", Dielectric{plain}});
    const Method method(scene);
    const MediaTable& media = method.prepared().media;
    const int flint = media.interior_of(0), clear = media.interior_of(1);
    EXPECT_TRUE(method.disperses(boundary_at({}, true, flint)));
    EXPECT_TRUE(method.disperses(boundary_at(MediaStack().entered(flint), true, clear)));
    EXPECT_FALSE(method.disperses(boundary_at({}, true, clear)));
}

TEST(Method, SpectralBinsAreRefused) {
    Scene scene = ball(RgbOrSpectral::rgb, SpectralColours::linear);
    scene.film.spectral_bins = 7;
    try {
        const Method method(scene);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("7 spectral bins"), std::string::npos);
    }
}

}  // namespace
}  // namespace dewbow::distributed_1989
