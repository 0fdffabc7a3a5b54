// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/empirical_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/monitors.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kRounding = 1e-13;

double node_nm(int i) { return 380.0 + 10.0 * i; }

/// r + g + b at the nodes before channels are brought to unit area: Fig. 4.3.
std::vector<double> summed(const EmpiricalCurves& curves) {
    std::vector<double> sums;
    for (const MonitorRgb& rgb : curves.per_nm) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 3; ++c) sum += rgb[c] * curves.area[c];
        sums.push_back(sum);
    }
    return sums;
}

struct Extrema {
    std::vector<double> peaks_nm;
    double least_nm = 0.0, least = 0.0;  ///< between the outer peaks, as a share of the maximum
};
Extrema extrema_of(const std::vector<double>& sums) {
    Extrema found;
    int first = 0, last = 0;
    for (int i = 1; i + 1 < int(sums.size()); ++i)
        if (sums[i] > sums[i - 1] && sums[i] > sums[i + 1]) {
            found.peaks_nm.push_back(node_nm(i));
            if (first == 0) first = i;
            last = i;
        }
    const auto least = std::min_element(sums.begin() + first, sums.begin() + last);
    found.least_nm = node_nm(int(least - sums.begin()));
    found.least = *least / *std::max_element(sums.begin(), sums.end());
    return found;
}

EmpiricalCurves curves(std::string_view monitor, NegativeColours negative,
                       EmpiricalWhite white = EmpiricalWhite::illuminant) {
    return empirical_curves(find_monitor(monitor).primaries, negative, white);
}

void expect_areas(const EmpiricalCurves& curves, std::array<double, 3> expected, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(curves.area[c], expected[c], tolerance) << c;
}

TEST(EmpiricalSpectrum, UnclampedIsTheMatrixOfTheMonitorScaledToB) {
    const auto b = find_illuminant("B");
    Colour<LinearSrgb> white;
    const auto at = [&](int i) {
        const double lambda = node_nm(i);
        return rgb_from_xyz<LinearSrgb>(Colour<Xyz>{cie_xyz_bar(lambda)} * (*b)(lambda * nm));
    };
    for (int i = 0; i < kEmpiricalNodes; ++i)
        white = white + at(i) * (i == 0 || i == kEmpiricalNodes - 1 ? 5.0 : 10.0);
    const EmpiricalCurves keep = curves("srgb", NegativeColours::keep);
    for (int i = 0; i < kEmpiricalNodes; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(keep.per_nm[std::size_t(i)][c], at(i)[c] / white[c], kRounding);
    expect_areas(keep, {1.0, 1.0, 1.0}, kRounding);
    // and linear between
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(keep.at(562.5 * nm)[c], 0.75 * keep.per_nm[18][c] + 0.25 * keep.per_nm[19][c],
                    kRounding);
}

TEST(EmpiricalSpectrum, EveryMonitorLacksAChannelAtEveryWavelength) {
    // "we expect that at all points in the spectrum at least one of the rgb values will be
    // negative": but Rec. 2020's red primary is the colour of 630 nm.
    for (const MonitorRow& monitor : monitors()) {
        const auto keep = empirical_curves(monitor.primaries, NegativeColours::keep);
        for (int i = 0; i < kEmpiricalNodes; ++i) {
            const MonitorRgb& rgb = keep.per_nm[std::size_t(i)];
            const bool inside = monitor.primaries.name == "rec2020" && node_nm(i) == 630.0;
            EXPECT_EQ(std::min({rgb[0], rgb[1], rgb[2]}) < 0.0, !inside)
                << monitor.primaries.name << ' ' << node_nm(i);
        }
    }
}

TEST(EmpiricalSpectrum, WithoutScalingToBWhiteIsTinted) {
    constexpr double kTwoDigits = 0.005;
    const auto own = EmpiricalWhite::monitor;
    expect_areas(curves("srgb", NegativeColours::keep, own), {1.25, 0.95, 0.75}, kTwoDigits);
    expect_areas(curves("srgb", NegativeColours::clamp, own), {1.67, 1.07, 0.87}, kTwoDigits);
}

TEST(EmpiricalSpectrum, SumsOfFigure43) {
    constexpr double kTwoDigits = 0.005;
    using Peaks = std::vector<double>;
    // With the monitor's own white, as the paper may have had it: peaks at 450 and 590 nm, and in
    // the cyan a minimum of .35.
    const auto own =
        extrema_of(summed(curves("rogers", NegativeColours::clamp, EmpiricalWhite::monitor)));
    EXPECT_EQ(own.peaks_nm, (Peaks{450.0, 590.0}));
    EXPECT_EQ(own.least_nm, 500.0);
    EXPECT_NEAR(own.least, 0.35, kTwoDigits);
    // Scaled to B, the orange is no longer the highest.
    const auto scaled = extrema_of(summed(curves("rogers", NegativeColours::clamp)));
    EXPECT_EQ(scaled.peaks_nm, (Peaks{450.0, 580.0}));
    EXPECT_EQ(scaled.least_nm, 500.0);
    EXPECT_NEAR(scaled.least, 0.38, kTwoDigits);
    const auto negative = extrema_of(summed(curves("rogers", NegativeColours::keep)));
    EXPECT_EQ(negative.peaks_nm, (Peaks{450.0, 590.0}));
    EXPECT_EQ(negative.least_nm, 510.0);
    EXPECT_NEAR(negative.least, 0.24, kTwoDigits);
}

TEST(EmpiricalSpectrum, ClampedIsUnclampedWithoutItsNegativesBroughtToUnitArea) {
    const auto keep = curves("ntsc", NegativeColours::keep);
    const auto clamp = curves("ntsc", NegativeColours::clamp);
    for (std::size_t c = 0; c < 3; ++c) {
        double area = 0.0;
        for (std::size_t i = 0; i < kEmpiricalNodes; ++i)
            area += 10.0 * std::max(0.0, keep.per_nm[i][c]);  // both ends are below 1e-5
        EXPECT_NEAR(clamp.area[c], area, 1e-4);
        for (std::size_t i = 0; i < kEmpiricalNodes; ++i)
            EXPECT_NEAR(clamp.per_nm[i][c] * clamp.area[c], std::max(0.0, keep.per_nm[i][c]),
                        kRounding);
    }
}

TEST(EmpiricalSpectrum, LimitedGoesTowardsWhiteAtItsLuminance) {
    const auto b = find_illuminant("B");
    double white_y = 0.0;
    const auto y_at = [&](int i) { return cie_xyz_bar(node_nm(i))[1] * (*b)(node_nm(i) * nm); };
    for (int i = 0; i < kEmpiricalNodes; ++i)
        white_y += y_at(i) * (i == 0 || i == kEmpiricalNodes - 1 ? 5.0 : 10.0);
    for (const MonitorRow& monitor : monitors()) {
        const auto keep = empirical_curves(monitor.primaries, NegativeColours::keep);
        const auto limit = empirical_curves(monitor.primaries, NegativeColours::limit);
        for (int i = 0; i < kEmpiricalNodes; ++i) {
            SCOPED_TRACE(testing::Message() << monitor.primaries.name << ' ' << node_nm(i));
            const double y = y_at(i) / white_y;
            const MonitorRgb from = keep.per_nm[std::size_t(i)];
            MonitorRgb to = limit.per_nm[std::size_t(i)];
            for (std::size_t c = 0; c < 3; ++c) to[c] *= limit.area[c];
            const double least = std::min({from[0], from[1], from[2]});
            EXPECT_NEAR(std::min({to[0], to[1], to[2]}), std::max(0.0, least), kRounding);
            // The same share of the way to grey (y, y, y) in each channel.
            const double left = least < 0.0 ? y / (y - least) : 1.0;
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(to[c] - y, left * (from[c] - y), kRounding);
        }
    }
    // Blue has little luminance to be grey at.
    EXPECT_NEAR(curves("rogers", NegativeColours::limit).area[2], 0.41, 0.005);
}

TEST(EmpiricalSpectrum, IsZeroOutside) {
    const auto clamp = curves("rogers", NegativeColours::clamp);
    for (double lambda_nm : {379.9, 770.1}) EXPECT_EQ(clamp.at(lambda_nm * nm), MonitorRgb{});
    EXPECT_EQ(clamp.at(770.0 * nm), clamp.per_nm.back());
    EXPECT_EQ(clamp.at(380.0 * nm), clamp.per_nm.front());
}

}  // namespace
}  // namespace dewbow
