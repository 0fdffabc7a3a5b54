// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/rgb.h"

#include <gtest/gtest.h>

#include "dewbow/spectrum/matrix3.h"

namespace dewbow {
namespace {

/// Column by column, the matrix that xyz_from_rgb applies.
template <class Space>
Matrix3 measured_matrix() {
    return matrix_of_columns(xyz_from_rgb(Colour<Space>{{1.0, 0.0, 0.0}}).v,
                             xyz_from_rgb(Colour<Space>{{0.0, 1.0, 0.0}}).v,
                             xyz_from_rgb(Colour<Space>{{0.0, 0.0, 1.0}}).v);
}

template <class Space>
void expect_matrix(const Matrix3& published, double tolerance) {
    const Matrix3 measured = measured_matrix<Space>();
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(measured[r][c], published[r][c], tolerance);
    }
}

TEST(RgbSpaces, SrgbIsTheStandards) {
    // IEC 61966-2-1:1999, four digits.
    expect_matrix<LinearSrgb>({{Triple{0.4124, 0.3576, 0.1805}, Triple{0.2126, 0.7152, 0.0722},
                                Triple{0.0193, 0.1192, 0.9505}}},
                              5.01e-5);
}

TEST(RgbSpaces, MatricesAreThePublishedOnes) {
    constexpr double kLastDigit = 1e-10;
    // ITU-R BT.2020 and Display P3: as computed by the Colour project from the standards'
    // chromaticities.
    expect_matrix<LinearRec2020>({{Triple{0.6369580483, 0.1446169036, 0.1688809752},
                                   Triple{0.2627002120, 0.6779980715, 0.0593017165},
                                   Triple{0.0, 0.0280726930, 1.0609850577}}},
                                 kLastDigit);
    expect_matrix<LinearDisplayP3>({{Triple{0.4865709486, 0.2656676932, 0.1982172852},
                                     Triple{0.2289745641, 0.6917385218, 0.0792869141},
                                     Triple{0.0, 0.0451133819, 1.0439443689}}},
                                   kLastDigit);
    // Academy S-2014-004, ACEScg.
    expect_matrix<AcesCg>({{Triple{0.6624541811, 0.1340042065, 0.1561876870},
                            Triple{0.2722287168, 0.6740817658, 0.0536895174},
                            Triple{-0.0055746495, 0.0040607335, 1.0103391003}}},
                          kLastDigit);
}

template <class Space>
void expect_round_trip() {
    constexpr double kRounding = 1e-14;
    const Colour<Space> rgb{{0.3, -0.2, 7.0}};
    const Colour<Space> back = rgb_from_xyz<Space>(xyz_from_rgb(rgb));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgb[c], 10 * kRounding);
    const Colour<Xyz> white = xyz_from_rgb(Colour<Space>{{1.0, 1.0, 1.0}});
    const auto [x, y] = primaries_of<Space>().white;
    EXPECT_NEAR(white[0], x / y, kRounding);
    EXPECT_NEAR(white[1], 1.0, kRounding);
    EXPECT_NEAR(white[2], (1.0 - x - y) / y, kRounding);
}

TEST(RgbSpaces, ConversionsUndoEachOther) {
    expect_round_trip<LinearSrgb>();
    expect_round_trip<LinearRec2020>();
    expect_round_trip<LinearDisplayP3>();
    expect_round_trip<AcesCg>();
}

TEST(RgbSpaces, HaveNames) {
    EXPECT_EQ(primaries_of<LinearSrgb>().name, "srgb");
    EXPECT_EQ(primaries_of<LinearRec2020>().name, "rec2020");
    EXPECT_EQ(primaries_of<LinearDisplayP3>().name, "display-p3");
    EXPECT_EQ(primaries_of<AcesCg>().name, "acescg");
}

constexpr std::array<double, 2> kD65{0.3127, 0.3290};
constexpr std::array<double, 2> kA{0.44757, 0.40745};

TEST(AdaptWhite, TakesWhiteToWhiteAndBack) {
    const Colour<Xyz> white_a{{kA[0] / kA[1], 1.0, (1.0 - kA[0] - kA[1]) / kA[1]}};
    const Colour<Xyz> adapted = adapt_white(white_a, kA, kD65);
    const Colour<Xyz> white_d65 = xyz_from_rgb(Colour<LinearSrgb>{{1.0, 1.0, 1.0}});
    const Colour<Xyz> back = adapt_white(adapted, kD65, kA);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(adapted[c], white_d65[c], 1e-14);
        EXPECT_NEAR(back[c], white_a[c], 1e-14);
    }
}

TEST(AdaptWhite, IsThePublishedMatrixFromD65ToD50) {
    // W3C, CSS Color Module Level 4, sample code, D65_to_D50 (2024), for these two whites.
    constexpr std::array<double, 2> kD50{0.3457, 0.3585};
    constexpr Matrix3 kPublished{
        {Triple{1.0479297925449969, 0.022946870601609652, -0.05019226628920524},
         Triple{0.02962780877005599, 0.9904344267538799, -0.017073799063418826},
         Triple{-0.009243040646204504, 0.015055191490298152, 0.7518742814281371}}};
    constexpr double kRounding = 1e-12;
    for (std::size_t column = 0; column < 3; ++column) {
        Colour<Xyz> one;
        one[column] = 1.0;
        const Colour<Xyz> adapted = adapt_white(one, kD65, kD50);
        for (std::size_t row = 0; row < 3; ++row) {
            EXPECT_NEAR(adapted[row], kPublished[row][column], kRounding);
        }
    }
}

}  // namespace
}  // namespace dewbow
