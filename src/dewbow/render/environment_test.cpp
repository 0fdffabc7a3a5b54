// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/environment.h"

#include <gtest/gtest.h>

#include <numbers>

#include "dewbow/render/rgb_lanes.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;

/// Pixel (x, y) is (x, y, 1).
std::shared_ptr<ImageEnvironment> numbered(int width, int height) {
    auto image = std::make_shared<ImageEnvironment>();
    image->width = width, image->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image->pixels.push_back({{double(x), double(y), 1.0}});
    return image;
}

TEST(EnvironmentMap, UpIsTheFirstRowAndForwardTheMiddle) {
    const EnvironmentMap map(numbered(8, 4));
    EXPECT_NEAR(map.radiance({0, 1, 0})[1], 0.0, kRounding);
    EXPECT_NEAR(map.radiance({0, -1, 0})[1], 3.0, kRounding);
    // The middle lies between columns 3 and 4, a quarter to the right between 5 and 6.
    EXPECT_NEAR(map.radiance({0, 0, -1})[0], 3.5, kRounding);
    EXPECT_NEAR(map.radiance({1, 0, 0})[0], 5.5, kRounding);
    EXPECT_NEAR(map.radiance({-1, 0, 0})[0], 1.5, kRounding);
    // Straight behind is the seam, where the last column meets the first.
    EXPECT_NEAR(map.radiance({0, 0, 1})[0], 3.5, kRounding);
    EXPECT_NEAR(map.radiance({0, 0, -1})[1], 1.5, kRounding);
}

TEST(EnvironmentMap, PixelCentresAreTheirPixels) {
    const EnvironmentMap map(numbered(8, 4));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const double theta = std::numbers::pi * (y + 0.5) / 4.0;
            const double phi = 2.0 * std::numbers::pi * ((x + 0.5) / 8.0 - 0.5);
            const Colour<LinearSrgb> c =
                map.radiance({std::sin(theta) * std::sin(phi), std::cos(theta),
                              -std::sin(theta) * std::cos(phi)});
            EXPECT_NEAR(c[0], x, 1e-9);
            EXPECT_NEAR(c[1], y, 1e-9);
        }
}

TEST(EnvironmentMap, TurnsWithItsFrame) {
    auto image = numbered(8, 4);
    // A quarter turn about y takes −z to −x.
    image->world_from_object = Transform<World, Object>(rotation({0, 1, 0}, 90.0 * unit::deg));
    image->scale = 2.0;
    const EnvironmentMap map(image);
    EXPECT_NEAR(map.radiance({-1, 0, 0})[0], 2.0 * 3.5, 1e-9);
    EXPECT_NEAR(map.radiance({0, 0, -1})[0], 2.0 * 5.5, 1e-9);
}

/// A sun of one pixel in a dark sky is found nearly by every sample, and its light has the variance
/// that the weights of one bright pixel promise: 1.44² − 1 = 1.09.
TEST(EnvironmentMap, SamplesASunWell) {
    constexpr int kSide = 400;             // a grid of numbers: no chance
    constexpr double kMostVariance = 1.2;  // and 0.1 for the rows' sine and the sky
    for (const int row : {2, 16}) {
        auto image = std::make_shared<ImageEnvironment>();
        image->width = 64, image->height = 32;
        image->pixels.assign(64 * 32, {{1.0, 1.0, 1.0}});
        image->pixels[std::size_t(row * 64)] = {{1e6, 1e6, 1e6}};  // on the seam
        const EnvironmentMap map(image);
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const auto s = map.sample({(i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide});
            const double value = map.radiance(s.direction)[1] / s.pdf;
            sum += value / (kSide * kSide);
            squares += value * value / (kSide * kSide);
        }
        EXPECT_LT(squares / (sum * sum) - 1.0, kMostVariance) << "row " << row;
    }
}

/// The spectra of a colour of light have the colour, whichever channel is the largest.
TEST(EnvironmentMap, RgbLightHasTheColourOfItsRgb) {
    constexpr double kLanes = 2e-3;  // 16 lanes, 256 rotations of them: what is left of their noise
    RgbLightLanes light;
    for (const Colour<LinearSrgb> rgb : {Colour<LinearSrgb>{{1, 1, 1}},
                                         {{0.2, 0.5, 3.0}},
                                         {{5.0, 0.1, 0.3}},
                                         {{0, 1, 0}},
                                         {{0.4, 0.4, 0.1}},
                                         {{0, 0, 0}}}) {
        Colour<Xyz> mean;
        for (int i = 0; i < 256; ++i) {
            const WavelengthPacket packet =
                sample_wavelengths(WavelengthSampling::visual, 16, (i + 0.5) / 256.0);
            light.begin(packet);
            LaneValues value;
            light.eval(rgb, LaneSet::all(packet), value);
            for (int k = 0; k < 16; ++k) ASSERT_GE(value[k], 0.0);
            mean = mean + xyz_from_lanes(packet, value.first(16)) * (1.0 / 256.0);
        }
        const Colour<Xyz> expected = xyz_from_rgb(rgb) * cie_y_integral();
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(mean[c], expected[c], kLanes * (expected[1] + expected[c]));
    }
}

}  // namespace
}  // namespace dewbow
