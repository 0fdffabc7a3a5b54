// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/base/random.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

using Rgb = Colour<LinearSrgb>;

/// Colour of `reflectance` under D65, perfect white having Y = 1.
Colour<Xyz> xyz_under_d65(const Spectrum& reflectance) {
    const SpectrumPtr d65 = find_illuminant("D65");
    std::vector<double> lambda_nm, value;
    for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 0.5) {
        lambda_nm.push_back(l);
        value.push_back(reflectance(l * unit::nm) * (*d65)(l * unit::nm));
    }
    const auto lit = make_tabulated(lambda_nm, value, OutsideTable::hold);
    return xyz_from_spectrum(*lit) * (1.0 / cie_y_integral());
}

Colour<Xyz> d65_white() {
    return xyz_from_spectrum(*find_illuminant("D65")) * (1.0 / cie_y_integral());
}

double round_trip_error(Rgb rgb) {
    return delta_e_2000(xyz_under_d65(*make_reflectance(rgb)), xyz_from_rgb(rgb), d65_white());
}

/// `count` colours of sRGB, evenly spread over the code values.
std::vector<Rgb> random_colours(int count) {
    std::vector<Rgb> colours;
    for (int i = 0; i < count; ++i) {
        const SampleKey key(stream_key(0, 0, 0), std::uint32_t(i));
        const auto rg = key.two(0, Purpose::test);
        const double b = key.one(1, Purpose::test);
        colours.push_back({{srgb_decode(rg[0]), srgb_decode(rg[1]), srgb_decode(b)}});
    }
    return colours;
}

/// Corners, edges and faces of the cube [0, 1]³ on a grid of five values an axis.
std::vector<Rgb> surface_colours() {
    constexpr std::array kGrid{0.0, 0.03, 0.25, 0.8, 1.0};
    std::vector<Rgb> colours;
    for (double r : kGrid) {
        for (double g : kGrid) {
            for (double b : kGrid) {
                const bool inside = std::min({r, g, b}) > 0.0 && std::max({r, g, b}) < 1.0;
                if (!inside) colours.push_back({{r, g, b}});
            }
        }
    }
    return colours;
}

/// Half of what a trained eye tells apart side by side. Measured: 0.14 at worst of the random ones,
/// 0.18 for dark purples, where the 5 nm nodes of the fit show.
constexpr double kInvisible = 0.5;

TEST(MakeReflectance, RandomColoursComeBack) {
    double worst = 0.0;
    for (const Rgb& rgb : random_colours(1000)) worst = std::max(worst, round_trip_error(rgb));
    EXPECT_LT(worst, kInvisible);
    RecordProperty("worst_delta_e_2000", std::to_string(worst));
}

TEST(MakeReflectance, CornersEdgesAndFacesComeBack) {
    for (const Rgb& rgb : surface_colours()) {
        EXPECT_LT(round_trip_error(rgb), kInvisible) << rgb[0] << " " << rgb[1] << " " << rgb[2];
    }
}

TEST(MakeReflectance, NearlyBlackColoursComeBack) {
    for (const Rgb& rgb : random_colours(300)) {
        for (double scale : {1e-2, 1e-4, 1e-7})
            EXPECT_LT(round_trip_error(rgb * scale), kInvisible);
    }
}

TEST(MakeReflectance, StaysBetweenZeroAndItsMaximum) {
    auto colours = surface_colours();
    for (const Rgb& rgb : random_colours(100)) colours.push_back(rgb);
    for (const Rgb& rgb : colours) {
        const SpectrumPtr reflectance = make_reflectance(rgb);
        EXPECT_LE(reflectance->max_value(), 1.0);
        double largest = 0.0;
        for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 1.0) {
            const double value = (*reflectance)(l * unit::nm);
            EXPECT_GE(value, 0.0);
            largest = std::max(largest, value);
        }
        EXPECT_LE(largest, reflectance->max_value());
        EXPECT_GE(largest, 0.97 * reflectance->max_value());  // "at most a few per cent above"
    }
}

TEST(MakeReflectance, GreyIsConstant) {
    for (double grey : {0.0, 1e-9, 0.18, 1.0}) {
        const SpectrumPtr reflectance = make_reflectance({{grey, grey, grey}});
        EXPECT_TRUE(reflectance->is_constant());
        EXPECT_EQ((*reflectance)(500.0 * unit::nm), grey);
    }
}

TEST(MakeReflectance, NearlyGreyIsNearlyConstant) {
    const SpectrumPtr reflectance = make_reflectance({{0.5, 0.5, 0.5 + 1e-6}});
    for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 10.0) {
        // The fit may stop 1e-3 in L*a*b* away: 3e-5 of the reflectance, and more at the ends of
        // the range.
        EXPECT_NEAR((*reflectance)(l * unit::nm), 0.5, 1e-3);
    }
}

TEST(MakeReflectance, ClampsToWhatASurfaceCanDo) {
    EXPECT_EQ((*make_reflectance({{2.0, 3.0, 4.0}}))(500.0 * unit::nm), 1.0);
    EXPECT_EQ((*make_reflectance({{-1.0, -2.0, std::nan("")}}))(500.0 * unit::nm), 0.0);
    EXPECT_LT(delta_e_2000(xyz_under_d65(*make_reflectance({{2.0, -1.0, 0.0}})),
                           xyz_from_rgb(Rgb{{1.0, 0.0, 0.0}}), d65_white()),
              kInvisible);
}

/// Colour difference of the light from what it stands for, both scaled so that `rgb`'s brightest
/// channel is 1.
double emission_error(Rgb rgb) {
    const double scale = 1.0 / std::max({rgb[0], rgb[1], rgb[2]});
    const Colour<Xyz> light = xyz_from_spectrum(*make_emission(rgb)) * (scale / cie_y_integral());
    return delta_e_2000(light, xyz_from_rgb(rgb * scale), d65_white());
}

TEST(MakeEmission, HasColourAndBrightness) {
    auto colours = surface_colours();
    for (const Rgb& rgb : random_colours(200)) colours.push_back(rgb);
    for (const Rgb& rgb : colours) {
        if (rgb == Rgb{}) continue;
        for (double scale : {1e-5, 1.0, 250.0}) {
            const Rgb light = rgb * scale;
            EXPECT_LT(emission_error(light), kInvisible);
            const double y = xyz_from_spectrum(*make_emission(light))[1] / cie_y_integral();
            EXPECT_NEAR(y / xyz_from_rgb(light)[1], 1.0, 1e-12);
        }
    }
}

TEST(MakeEmission, WhiteIsD65) {
    const SpectrumPtr light = make_emission({{2.0, 2.0, 2.0}});
    const SpectrumPtr d65 = find_illuminant("D65");
    for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 5.0) {
        EXPECT_DOUBLE_EQ((*light)(l * unit::nm), 2.0 * (*d65)(l * unit::nm));
    }
}

TEST(MakeEmission, BlackIsDark) {
    EXPECT_EQ(make_emission({})->max_value(), 0.0);
    EXPECT_EQ(make_emission({{-1.0, 0.0, 0.0}})->max_value(), 0.0);
}

TEST(MakeAbsorption, GivesTheTransmittanceAtItsDepth) {
    const Rgb blue{{0.2, 0.5, 0.9}};
    const double depth_m = 0.25;
    const SpectrumPtr absorption = make_absorption(blue, depth_m * unit::m);
    const SpectrumPtr transmittance = make_reflectance(blue);
    for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 5.0) {
        const double through = std::exp(-(*absorption)(l * unit::nm) * depth_m);
        EXPECT_NEAR(through, (*transmittance)(l * unit::nm), 1e-12);
    }
}

TEST(MakeAbsorption, GreyIsConstantAndClearIsNothing) {
    const SpectrumPtr grey = make_absorption({{0.5, 0.5, 0.5}}, 2.0 * unit::m);
    EXPECT_TRUE(grey->is_constant());
    EXPECT_DOUBLE_EQ(grey->max_value(), std::log(2.0) / 2.0);
    EXPECT_EQ(make_absorption({{1.0, 1.0, 1.0}}, 1.0 * unit::m)->max_value(), 0.0);
    EXPECT_DOUBLE_EQ(make_absorption({}, 1.0 * unit::m)->max_value(), std::log(1e6));
    EXPECT_THROW(make_absorption({}, 0.0 * unit::m), InputError);
}

}  // namespace
}  // namespace dewbow
