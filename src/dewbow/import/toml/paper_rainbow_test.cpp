// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/paper_rainbow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

using unit::deg;
using unit::m;

PaperRainbow rainbow_of(const std::string& keys) {
    return parse_scene_toml("scene.toml", "[paper_rainbow]\n" + keys).scene.paper_rainbow.value();
}

TEST(PaperRainbowToml, IsTheTableAsPublishedUnlessToldOtherwise) {
    EXPECT_FALSE(parse_scene_toml("scene.toml", "").scene.paper_rainbow);
    const PaperRainbow rainbow = rainbow_of("");
    const auto& method = std::get<PaperMethod>(rainbow.bow);
    EXPECT_EQ(method.rays, 50'000);
    EXPECT_EQ(method.wavelengths, kPaperSamples);
    EXPECT_EQ(method.kernel, SunKernel::five_entries);
    EXPECT_EQ(rainbow.equation, FogEquation::corrected);
    EXPECT_EQ(rainbow.depth, 1000.0 * m);
    EXPECT_FALSE(rainbow.luminance);
    EXPECT_FALSE(rainbow.chaos);
}

TEST(PaperRainbowToml, ReadsTables) {
    const auto corrected = std::get<PaperMethod>(rainbow_of("method = \"corrected\"").bow);
    EXPECT_TRUE(corrected.per_solid_angle);
    EXPECT_EQ(corrected.kernel, SunKernel::disc);
    const auto own = std::get<PaperMethod>(
        rainbow_of("wavelengths = 39\nsun = \"none\"\njitter_wavelengths = true").bow);
    EXPECT_EQ(own.wavelengths, 39);
    EXPECT_EQ(own.kernel, SunKernel::none);
    EXPECT_TRUE(own.jitter_wavelengths);
}

TEST(PaperRainbowToml, ReadsRings) {
    constexpr double kRounding = 1e-12;
    const PaperRainbow rainbow = rainbow_of(
        "kind = \"rings\"\nangle_deg = 50\nwidth_deg = 4\nindex = \"angle\"\njitter = 1.5\n"
        "colour_jitter = true\ntransmittance = [1, 2, 3]\nequation = \"printed\"\n"
        "fog_per_m = 0.002\nrain_depth_m = 300\nluminance_cd_m2 = 5000");
    const auto& rings = std::get<PaperRings>(rainbow.bow);
    EXPECT_NEAR(rings.bow.outer.to(deg), 52.0, kRounding);
    EXPECT_NEAR(rings.bow.inner.to(deg), 48.0, kRounding);
    EXPECT_EQ(rings.bow.index, ImpressionisticBow::Index::by_angle);
    EXPECT_EQ(rings.bow.jitter.delta, 1.5);
    EXPECT_TRUE(rings.bow.jitter.colour);
    EXPECT_EQ(rings.transmittance, (Colour<LinearSrgb>{{1, 2, 3}}));
    EXPECT_EQ(rainbow.equation, FogEquation::printed);
    EXPECT_NEAR(rainbow.constant.to(1.0 / m), 0.002, kRounding);
    EXPECT_EQ(rainbow.depth, 300.0 * m);
    EXPECT_EQ(rainbow.luminance, 5000.0);
    EXPECT_EQ(
        std::get<PaperRings>(rainbow_of("kind = \"rings\"\ntransmittance = 2").bow).transmittance,
        (Colour<LinearSrgb>{{2, 2, 2}}));
    EXPECT_TRUE(std::isinf(rainbow_of("rain_depth_m = \"infinite\"").depth.to(m)));
}

TEST(PaperRainbowToml, ReadsChaosOfDirections) {
    const Chaos chaos = *rainbow_of(
                             "chaos = { size_deg = 9, octaves = 4, lacunarity = 3, exponent = 3, "
                             "axis = [0, 2, 0], stretch = 5, seed = 7, bias = -0.5, gain = 2 }")
                             .chaos;
    EXPECT_NEAR(chaos.base_frequency, 20.0 / std::numbers::pi, 1e-12);  // one in 9°
    EXPECT_EQ(chaos.octaves, 4);
    EXPECT_EQ(chaos.lacunarity, 3.0);
    EXPECT_EQ(chaos.exponent, 3.0);
    EXPECT_EQ(chaos.axis, (Vec3{0, 1, 0}));
    EXPECT_EQ(chaos.stretch, 5.0);
    EXPECT_EQ(chaos.seed, 7u);
    EXPECT_EQ(chaos.bias, -0.5);
    EXPECT_EQ(chaos.gain, 2.0);
}

TEST(PaperRainbowToml, WrongValuesAreNamed) {
    struct Wrong {
        const char *keys, *phrase;
    };
    for (const auto& [keys, phrase] : {
             Wrong{"kind = \"ring\"", "did you mean \"rings\""},
             Wrong{"jitter = 1", "unknown key \"jitter\" in [paper_rainbow]"},
             Wrong{"fog_per_m = 0", "fog_per_m is 0"},
             Wrong{"rain_depth_m = \"infinity\"", "did you mean \"infinite\""},
             Wrong{"kind = \"rings\"\nangle_deg = 1\nwidth_deg = 3", "width_deg is 3"},
             Wrong{"method = \"corrected\"\njitter_wavelengths = true",
                   "jitter goes with method = \"published\""},
             Wrong{"equation = \"printed\"\nrain_depth_m = \"infinite\"", "it must be 0 to 20"},
             Wrong{"chaos = { octaves = 3 }", "chaos of [paper_rainbow] needs size_deg"},
             Wrong{"chaos = { size_m = 3 }", "chaos of [paper_rainbow] needs size_deg"},
         }) {
        try {
            rainbow_of(keys);
            ADD_FAILURE() << keys;
        } catch (const InputError& error) {
            const std::string text = std::string(error.what()) + error.hint();
            EXPECT_NE(text.find(phrase), std::string::npos) << text;
        }
    }
}

TEST(PaperRainbowToml, NeedsASun) {
    Scene scene = parse_scene_toml("scene.toml", "[paper_rainbow]").scene;
    try {
        validate(scene);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(error.sentence(),
                  "paper rainbow: there is no sun, a light of type \"distant\", to stand opposite");
    }
    scene.lights.push_back(DistantLight{{{0, -1, 0}}, Angle{}, make_constant(1.0)});
    validate(scene);
}

}  // namespace
}  // namespace dewbow
