// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;

/// Texel (x, y) has R = x, G = y, B = 0 in units of 1/255, A = 255.
std::shared_ptr<TextureImage> numbered(int width, int height) {
    auto image = std::make_shared<TextureImage>();
    image->width = width, image->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x, y, 0, 255}) image->texels8.push_back(std::uint8_t(value));
    return image;
}

Texture linear_texture(int width, int height) {
    Texture texture;
    texture.image = numbered(width, height);
    texture.coding = TextureCoding::linear;
    return texture;
}

/// Column and row of what is found there, in texels.
std::array<double, 2> place(const Texture& texture, double u, double v) {
    const auto rgba = texture.eval({u, v});
    return {rgba[0] * 255.0, rgba[1] * 255.0};
}

TEST(Texture, CentresOfTexelsAreExact) {
    const Texture texture = linear_texture(4, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
            const auto at = place(texture, (x + 0.5) / 4.0, (y + 0.5) / 3.0);
            EXPECT_NEAR(at[0], x, kRounding);
            EXPECT_NEAR(at[1], y, kRounding);
        }
}

TEST(Texture, IsBilinearBetweenCentres) {
    const auto at = place(linear_texture(4, 4), 1.75 / 4.0, 2.2 / 4.0);
    EXPECT_NEAR(at[0], 1.25, kRounding);
    EXPECT_NEAR(at[1], 1.7, kRounding);
}

TEST(Texture, TheNearestTexelFillsItsSquare) {
    Texture texture = linear_texture(4, 4);
    texture.interpolates = false;
    EXPECT_EQ(place(texture, 0.0, 0.0)[0], 0.0);
    EXPECT_NEAR(place(texture, 0.4999, 0.0)[0], 1.0, kRounding);
    EXPECT_NEAR(place(texture, 0.5001, 0.0)[0], 2.0, kRounding);
    EXPECT_EQ(place(texture, 1.0, 0.0)[0], 0.0);  // the next repetition begins
}

TEST(Texture, WrapsEachWay) {
    Texture texture = linear_texture(4, 4);
    texture.interpolates = false;
    const double inside = 1.5 / 4.0, outside = 1.0 + inside, before = -inside;
    EXPECT_NEAR(place(texture, outside, 0.5)[0], 1.0, kRounding);
    EXPECT_NEAR(place(texture, before, 0.5)[0], 2.0, kRounding);
    texture.wrap_u = TextureWrap::mirror;
    EXPECT_NEAR(place(texture, outside, 0.5)[0], 2.0, kRounding);
    EXPECT_NEAR(place(texture, before, 0.5)[0], 1.0, kRounding);
    texture.wrap_u = TextureWrap::clamp;
    EXPECT_NEAR(place(texture, outside, 0.5)[0], 3.0, kRounding);
    EXPECT_NEAR(place(texture, before, 0.5)[0], 0.0, kRounding);
}

TEST(Texture, InterpolatesAcrossTheSeam) {
    Texture texture = linear_texture(4, 1);
    EXPECT_NEAR(place(texture, 0.0, 0.5)[0], 1.5, kRounding);  // between columns 3 and 0
    texture.wrap_u = TextureWrap::clamp;
    EXPECT_NEAR(place(texture, 0.0, 0.5)[0], 0.0, kRounding);
}

/// IEC 61966-2-1: code 188 of 255 is 0.5028865 of full light; alpha is not coded.
TEST(Texture, SrgbIsDecodedBeforeItIsFiltered) {
    auto image = std::make_shared<TextureImage>();
    image->width = 2, image->height = 1;
    image->texels8 = {0, 0, 0, 0, 255, 255, 255, 188};
    Texture texture;
    texture.image = image;
    EXPECT_NEAR(texture.eval({0.5, 0.5})[0], 0.5, kRounding);
    EXPECT_NEAR(texture.eval({0.75, 0.5})[3], 188.0 / 255.0, kRounding);
    image->texels8 = {188, 188, 188, 255, 188, 188, 188, 255};
    constexpr double kPublishedDigits = 1e-6;
    EXPECT_NEAR(texture.eval({0.5, 0.5})[0], 0.5028865, kPublishedDigits);
}

TEST(Texture, SixteenBitsKeepTheirSteps) {
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 1;
    image->bits = 16;
    image->texels16 = {1, 257, 65535, 32768};
    Texture texture;
    texture.image = image;
    texture.coding = TextureCoding::linear;
    const auto rgba = texture.eval({0.3, 0.8});
    EXPECT_NEAR(rgba[0], 1.0 / 65535.0, kRounding);
    EXPECT_NEAR(rgba[1], 1.0 / 255.0, kRounding);
    EXPECT_NEAR(rgba[2], 1.0, kRounding);
}

TEST(Texture, TheTransformMapsTheSurfaceToThePicture) {
    Texture texture = linear_texture(4, 4);
    texture.interpolates = false;
    texture.transform = {{{0.0, 2.0, 0.25}, {-2.0, 0.0, 1.0}}};
    // (0.1, 0.2) -> (0.65, 0.8)
    EXPECT_NEAR(place(texture, 0.1, 0.2)[0], 2.0, kRounding);
    EXPECT_NEAR(place(texture, 0.1, 0.2)[1], 3.0, kRounding);
}

TEST(Texture, NoCoordinateLeavesThePicture) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp})
        for (const bool interpolates : {true, false})
            for (const double u : {1e300, -1e300, 1e18, -1e9 - 0.5, infinite, -infinite,
                                   std::numeric_limits<double>::quiet_NaN()}) {
                Texture texture = linear_texture(3, 5);
                texture.wrap_u = texture.wrap_v = wrap;
                texture.interpolates = interpolates;
                const auto rgba = texture.eval({u, -u});
                EXPECT_TRUE(rgba[0] >= 0.0 && rgba[0] <= 2.0 / 255.0 + kRounding) << u;
                EXPECT_TRUE(rgba[1] >= 0.0 && rgba[1] <= 4.0 / 255.0 + kRounding) << u;
            }
}

}  // namespace
}  // namespace dewbow
