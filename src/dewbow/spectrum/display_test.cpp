// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

using Rgb = Colour<LinearSrgb>;
constexpr double kRounding = 1e-14;

TEST(Srgb, CurvesUndoEachOther) {
    for (int i = -2000; i <= 2000; ++i) {
        const double encoded = i / 1000.0;
        // The published constants leave a step of 2e-8 where the parts meet, at 0.04045.
        EXPECT_NEAR(srgb_encode(srgb_decode(encoded)), encoded, 1e-7);
    }
}

TEST(Srgb, HasThePublishedValues) {
    EXPECT_EQ(srgb_encode(0.0), 0.0);
    EXPECT_NEAR(srgb_encode(1.0), 1.0, kRounding);
    EXPECT_NEAR(srgb_decode(1.0), 1.0, kRounding);
    EXPECT_NEAR(srgb_encode(0.002), 0.02584, kRounding);  // the straight part: 12.92 × 0.002
    EXPECT_NEAR(srgb_decode(0.5), 0.21404114048223255, kRounding);  // ((0.5 + 0.055) / 1.055)^2.4
    EXPECT_EQ(srgb_encode(-0.3), -srgb_encode(0.3));
    EXPECT_EQ(srgb_decode(-0.3), -srgb_decode(0.3));
}

TEST(GamutMapping, NamesAreUnderstood) {
    for (const std::string& name : gamut_mapping_names())
        EXPECT_NO_THROW(gamut_mapping_from_name(name));
    EXPECT_EQ(gamut_mapping_from_name("clip"), GamutMapping::clip);
    EXPECT_EQ(gamut_mapping_from_name("towards_white"), GamutMapping::towards_white);
    try {
        gamut_mapping_from_name("toward_white");
        FAIL() << "not thrown";
    } catch (const InputError& error) {
        EXPECT_NE(error.hint().find("towards_white"), std::string::npos);
    }
}

template <class Space>
void expect_luminance_kept(Colour<Space> rgb) {
    const double luminance = xyz_from_rgb(rgb)[1];
    ASSERT_GT(luminance, 0.0);
    const Colour<Space> mapped = map_gamut(rgb, GamutMapping::towards_white);
    EXPECT_NEAR(xyz_from_rgb(mapped)[1], luminance, 4.0 * kRounding * luminance);
    EXPECT_GE(std::min({mapped[0], mapped[1], mapped[2]}), 0.0);
}

TEST(MapGamut, KeepsLuminance) {
    expect_luminance_kept<LinearSrgb>({{-0.2, 0.5, 0.3}});
    expect_luminance_kept<LinearSrgb>({{3.0, -0.4, -0.9}});
    expect_luminance_kept<LinearRec2020>({{0.9, -0.1, 0.0}});
    expect_luminance_kept<LinearDisplayP3>({{0.0, 0.2, -0.3}});
    expect_luminance_kept<AcesCg>({{-0.05, 0.2, 0.3}});
}

TEST(MapGamut, MovesStraightTowardsGrey) {
    const Rgb rgb{{-0.2, 0.5, 0.3}};
    const Rgb mapped = map_gamut(rgb, GamutMapping::towards_white);
    const double luminance = xyz_from_rgb(rgb)[1];
    const double saturation = (mapped[1] - luminance) / (rgb[1] - luminance);
    EXPECT_NEAR(mapped[0], 0.0, kRounding);
    EXPECT_NEAR(mapped[2], luminance + saturation * (rgb[2] - luminance), kRounding);
}

TEST(MapGamut, LeavesWhatIsInside) {
    const Rgb inside{{0.0, 0.4, 7.0}};
    EXPECT_EQ(map_gamut(inside, GamutMapping::towards_white), inside);
    EXPECT_EQ(map_gamut(inside, GamutMapping::clip), inside);
}

TEST(MapGamut, ClipCutsAndDarkIsBlack) {
    EXPECT_EQ(map_gamut(Rgb{{-1.0, 0.5, 2.0}}, GamutMapping::clip), (Rgb{{0.0, 0.5, 2.0}}));
    EXPECT_EQ(map_gamut(Rgb{{0.1, -1.0, 0.1}}, GamutMapping::towards_white), Rgb{});
}

Colour<Xyz> grey(double linear) { return xyz_from_rgb(Rgb{{linear, linear, linear}}); }

/// Mean code values of a flat field.
constexpr int kFieldSide = 256;
std::array<double, 3> mean_codes(Colour<Xyz> xyz, const DisplaySettings& settings = {}) {
    std::array<double, 3> sum{};
    for (int y = 0; y < kFieldSide; ++y) {
        for (int x = 0; x < kFieldSide; ++x) {
            const auto codes = srgb8_from_xyz(xyz, settings, x, y);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += codes[c];
        }
    }
    for (double& value : sum) value /= kFieldSide * kFieldSide;
    return sum;
}
/// Five standard errors of such a mean: a dithered code has sd √(1/6 + 1/12) = 0.5 at most.
constexpr double kFieldError = 5.0 * 0.5 / kFieldSide;

TEST(Srgb8, DitherIsUnbiasedOverAFlatField) {
    for (double code : {0.1, 0.45, 0.7, 1.2, 10.0, 99.5, 128.25, 253.9, 254.4, 254.75}) {
        for (double mean : mean_codes(grey(srgb_decode(code / 255.0)))) {
            EXPECT_NEAR(mean, code, kFieldError) << code;
        }
    }
}

TEST(Srgb8, BlackAndWhiteStayExact) {
    EXPECT_EQ(mean_codes({}), (std::array<double, 3>{}));
    EXPECT_EQ(mean_codes(grey(3.0)), (std::array<double, 3>{255.0, 255.0, 255.0}));
}

TEST(Srgb8, DitherIsTheSameEachTimeAndDiffersBetweenPixels) {
    const Colour<Xyz> xyz = grey(0.2);
    EXPECT_EQ(srgb8_from_xyz(xyz, {}, 12, 7), srgb8_from_xyz(xyz, {}, 12, 7));
    std::set<std::array<std::uint8_t, 3>> seen;
    for (int x = 0; x < 100; ++x) seen.insert(srgb8_from_xyz(xyz, {}, x, 3));
    EXPECT_GT(seen.size(), 5u);
    // Triangular and one code value wide: three neighbouring codes a channel, or two.
    for (const auto& codes : seen) EXPECT_NEAR(codes[0], 255.0 * srgb_encode(0.2), 1.5);
}

TEST(Srgb8, RoundsWithoutDither) {
    DisplaySettings settings;
    settings.dither = false;
    for (const double code : {0.0, 0.4, 0.6, 99.6, 128.4, 254.6, 255.0})
        for (int x = 0; x < 5; ++x)
            for (const std::uint8_t channel :
                 srgb8_from_xyz(grey(srgb_decode(code / 255.0)), settings, x, 3))
                EXPECT_EQ(channel, std::lround(code));
}

TEST(Srgb8, ExposureCountsInStops) {
    const auto brighter = mean_codes(grey(0.1), {.exposure_stops = 2.0});
    EXPECT_NEAR(brighter[1], 255.0 * srgb_encode(0.4), kFieldError);
}

TEST(Srgb8, TheChosenWhiteLooksWhite) {
    constexpr std::array<double, 2> kA{0.44757, 0.40745};
    const Colour<Xyz> lamp{{0.5 * kA[0] / kA[1], 0.5, 0.5 * (1.0 - kA[0] - kA[1]) / kA[1]}};
    for (double mean : mean_codes(lamp, {.white = kA})) {
        EXPECT_NEAR(mean, 255.0 * srgb_encode(0.5), kFieldError);
    }
}

TEST(Srgb8, BrightColoursPaleButKeepTheirLuminance) {
    const Rgb bright{{2.0, 0.3, 0.1}};
    const double luminance = xyz_from_rgb(bright)[1];
    ASSERT_LT(luminance, 1.0);
    const auto mean = mean_codes(xyz_from_rgb(bright));
    Rgb shown;
    for (std::size_t c = 0; c < 3; ++c) shown[c] = srgb_decode(mean[c] / 255.0);
    EXPECT_NEAR(xyz_from_rgb(shown)[1], luminance, 1e-3);
    EXPECT_EQ(mean[0], 255.0);
    EXPECT_GT(mean[1], mean[2]);  // still orange
}

TEST(Srgb8, SurvivesWhatIsNoColour) {
    const double nan = std::nan("");
    EXPECT_EQ(srgb8_from_xyz({{nan, nan, nan}}, {}, 0, 0), (std::array<std::uint8_t, 3>{}));
    EXPECT_NO_FATAL_FAILURE(srgb8_from_xyz({{INFINITY, 1.0, 0.0}}, {}, 0, 0));
    EXPECT_NO_FATAL_FAILURE(srgb8_from_xyz({{-1.0, -1.0, -1.0}}, {}, 0, 0));
}

}  // namespace
}  // namespace dewbow
