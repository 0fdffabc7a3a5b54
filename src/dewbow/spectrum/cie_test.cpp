// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/cie.h"

#include <gtest/gtest.h>

namespace dewbow {
namespace {

TEST(Cie, ColumnsSumToWhatTheyShould) {
    // Sums of the 471 published values, added up apart from this program.
    constexpr std::array<double, 3> kSums{106.865469, 106.856917, 106.892251};
    constexpr double kLastDigit = 1e-6;
    std::array<double, 3> sum{};
    for (int i = 0; i <= 470; ++i) {
        const auto bar = cie_xyz_bar(360.0 + i);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += bar[c];
    }
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], kSums[c], kLastDigit);
}

TEST(Cie, SpectralLocusLiesWhereItIsPublished) {
    struct LocusPoint {
        double lambda_nm, x, y;
    };
    // CIE 15:2004, chromaticity coordinates of the 2° observer, five digits.
    constexpr LocusPoint kLocus[] = {
        {400.0, .17334, .00480}, {450.0, .15664, .01770}, {480.0, .09129, .13270},
        {500.0, .00817, .53842}, {520.0, .07430, .83380}, {560.0, .37310, .62445},
        {600.0, .62704, .37249}, {650.0, .72599, .27401}, {700.0, .73469, .26531}};
    constexpr double kHalfLastDigit = 5.01e-6;
    for (const LocusPoint& point : kLocus) {
        const auto bar = cie_xyz_bar(point.lambda_nm);
        const double sum = bar[0] + bar[1] + bar[2];
        EXPECT_NEAR(bar[0] / sum, point.x, kHalfLastDigit) << point.lambda_nm;
        EXPECT_NEAR(bar[1] / sum, point.y, kHalfLastDigit) << point.lambda_nm;
    }
}

TEST(Cie, IsLinearBetweenAndZeroOutside) {
    const auto a = cie_xyz_bar(444.0), b = cie_xyz_bar(445.0), between = cie_xyz_bar(444.25);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(between[c], 0.75 * a[c] + 0.25 * b[c], 1e-15);
    EXPECT_EQ(cie_xyz_bar(359.999), (std::array<double, 3>{}));
    EXPECT_EQ(cie_xyz_bar(830.001), (std::array<double, 3>{}));
    EXPECT_GT(cie_xyz_bar(360.0)[2], 0.0);
    EXPECT_GT(cie_xyz_bar(830.0)[0], 0.0);
}

TEST(Cie, LuminousCurvePeaksAtOne) { EXPECT_EQ(cie_xyz_bar(555.0)[1], 1.0); }

TEST(Cie, IntegralIsTheTrapezoidSum) {
    // The sum of the column less half of its ends; linear interpolation makes the rule exact.
    const double ends = cie_xyz_bar(360.0)[1] + cie_xyz_bar(830.0)[1];
    EXPECT_NEAR(cie_y_integral(), 106.856917 - 0.5 * ends, 1e-6);
}

TEST(Cie, ALineIsSeenWithItsWholeStrength) {
    constexpr double kStrength = 3.0;
    const auto bar = cie_xyz_bar(555.0);
    const auto xyz = xyz_from_spectrum(*make_lines({{555.0 * unit::nm, kStrength}}));
    // Over ±0.5 nm the curves are straight but for their second derivative, 1e-3 nm⁻² at most.
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(xyz[c], kStrength * bar[c], kStrength * 5e-3);
    EXPECT_NEAR(xyz[1] / kStrength, 1.0, 1e-3);
}

TEST(Cie, LanesAreAddedByTheirDensity) {
    WavelengthPacket packet;
    packet.count = 4;
    packet.lambda_nm = {450.0, 500.25, 600.0, 900.0};
    packet.pdf_per_nm = {0.001, 0.002, 0.004, 0.001};
    const std::array<double, 4> values{1.0, 2.0, 3.0, 5.0};
    const Colour<Xyz> xyz = xyz_from_lanes(packet, values);
    for (std::size_t c = 0; c < 3; ++c) {
        double expected = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            expected +=
                values[k] * cie_xyz_bar(packet.lambda_nm[k])[c] / packet.pdf_per_nm[k] / 4.0;
        }
        EXPECT_NEAR(xyz[c], expected, 1e-12 * expected);
    }
}

}  // namespace
}  // namespace dewbow
