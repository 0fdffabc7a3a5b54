// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/rgb_lanes.h"

#include <gtest/gtest.h>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// The spectrum of `rgb` at every nanometre, through packets of one lane.
std::vector<double> spectrum_of(RgbLanes& lanes_of, Colour<LinearSrgb> rgb) {
    std::vector<double> values;
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; lambda_nm += 1.0) {
        WavelengthPacket packet;
        packet.count = 1;
        packet.lambda_nm[0] = lambda_nm;
        lanes_of.begin(packet);
        LaneValues value;
        lanes_of.eval(rgb, LaneSet::all(packet), value);
        values.push_back(value[0]);
    }
    return values;
}

/// Linear sRGB of a reflectance under D65, by sums over nanometres.
Colour<LinearSrgb> seen_under_d65(const std::vector<double>& reflectance) {
    const SpectrumPtr d65 = find_illuminant("D65");
    Colour<Xyz> sum{}, white{};
    for (std::size_t i = 0; i < reflectance.size(); ++i) {
        const double lambda_nm = kLambdaMin_nm + double(i);
        const auto bar = cie_xyz_bar(lambda_nm);
        for (std::size_t c = 0; c < 3; ++c) {
            const double density = (*d65)(lambda_nm * unit::nm) * bar[c];
            sum[c] += reflectance[i] * density;
            white[c] += density;
        }
    }
    return rgb_from_xyz<LinearSrgb>(sum * (1.0 / white[1]));
}

const std::vector<Colour<LinearSrgb>>& colours() {
    static const std::vector<Colour<LinearSrgb>> all = [] {
        std::vector<Colour<LinearSrgb>> result;
        for (const double r : {0.0, 0.2, 0.55, 1.0})
            for (const double g : {0.0, 0.1, 0.7, 1.0})
                for (const double b : {0.0, 0.35, 1.0}) result.push_back({{r, g, b}});
        return result;
    }();
    return all;
}

/// The seven basis spectra are solved for their colours to this, the most saturated ones worst: a
/// thousandth of white is below what 8 bits show.
constexpr double kColourError = 2e-3;

TEST(RgbReflectanceLanes, HaveTheirColourUnderDaylight) {
    RgbReflectanceLanes lanes;
    for (const Colour<LinearSrgb>& rgb : colours()) {
        const Colour<LinearSrgb> seen = seen_under_d65(spectrum_of(lanes, rgb));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c], rgb[c], kColourError)
                << rgb[0] << ", " << rgb[1] << ", " << rgb[2] << " channel " << c;
    }
}

TEST(RgbReflectanceLanes, NeverReflectMoreThanTheBrightestChannel) {
    RgbReflectanceLanes lanes;
    constexpr double kRounding = 1e-12;
    for (const Colour<LinearSrgb>& rgb : colours()) {
        const double most = std::max({rgb[0], rgb[1], rgb[2]});
        for (const double value : spectrum_of(lanes, rgb)) {
            EXPECT_GE(value, 0.0);
            EXPECT_LE(value, most + kRounding);
        }
    }
}

TEST(RgbReflectanceLanes, GreyIsTheSameAtEveryWavelength) {
    RgbReflectanceLanes lanes;
    for (const double value : spectrum_of(lanes, {{0.3, 0.3, 0.3}})) EXPECT_EQ(value, 0.3);
}

/// A packet's lanes keep their numbers when some have gone.
TEST(RgbReflectanceLanes, OneLaneIsTheSameAsAmongAll) {
    WavelengthPacket packet;
    packet.count = 4;
    for (int k = 0; k < 4; ++k) packet.lambda_nm[std::size_t(k)] = 400.0 + 90.0 * k;
    RgbReflectanceLanes lanes;
    lanes.begin(packet);
    const Colour<LinearSrgb> rgb{{0.9, 0.4, 0.1}};
    LaneValues all, one;
    lanes.eval(rgb, LaneSet::all(packet), all);
    for (int k = 0; k < 4; ++k) {
        lanes.eval(rgb, LaneSet::one(packet, k), one);
        EXPECT_EQ(one[0], all[k]);
    }
}

}  // namespace
}  // namespace dewbow
