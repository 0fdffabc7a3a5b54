// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

Image constant_image(int width, int height, float value) {
    Image image{width, height, {}};
    for (const char* name : {"R", "G", "B"})
        image.channels.push_back(
            {name, std::vector<float>(static_cast<std::size_t>(width * height), value)});
    return image;
}

TEST(Compare, EqualPicturesDifferByNothing) {
    const ImageDifference difference =
        compare_rgb(constant_image(3, 2, 0.7f), constant_image(3, 2, 0.7f));
    EXPECT_EQ(difference.mean_squared, 0.0);
    EXPECT_EQ(difference.relative_mean_squared, 0.0);
    EXPECT_EQ(difference.worst, 0.0);
}

TEST(Compare, OneWrongValueCountsAsItsDefinitionSays) {
    Image image = constant_image(4, 3, 2.0f);
    image.channels[1].values[2 * 4 + 3] = 5.0f;
    const double floor = 1.5;
    const ImageDifference difference = compare_rgb(image, constant_image(4, 3, 2.0f), floor);
    const double values = 3 * 4 * 3;
    EXPECT_DOUBLE_EQ(difference.mean_squared, 9.0 / values);
    EXPECT_DOUBLE_EQ(difference.relative_mean_squared, 9.0 / (4.0 + 2.25) / values);
    EXPECT_EQ(difference.worst_x, 3);
    EXPECT_EQ(difference.worst_y, 2);
    EXPECT_EQ(difference.worst, 3.0);
}

TEST(Compare, NaNIsTheWorstPixelAndNeverAveragedAway) {
    Image image = constant_image(2, 2, 1.0f);
    image.channels[0].values[1] = 1e30f;
    image.channels[2].values[2] = std::numeric_limits<float>::quiet_NaN();
    const ImageDifference difference = compare_rgb(image, constant_image(2, 2, 1.0f));
    EXPECT_TRUE(std::isinf(difference.mean_squared));
    EXPECT_TRUE(std::isinf(difference.relative_mean_squared));
    EXPECT_TRUE(std::isinf(difference.worst));
    EXPECT_EQ(difference.worst_x, 0);
    EXPECT_EQ(difference.worst_y, 1);
}

TEST(Compare, WhatCannotBeComparedIsRefused) {
    const Image image = constant_image(2, 2, 1.0f);
    EXPECT_THROW(compare_rgb(image, constant_image(2, 3, 1.0f)), InputError);
    Image grey{2, 2, {{"Y", std::vector<float>(4, 1.0f)}}};
    EXPECT_THROW(compare_rgb(grey, image), InputError);
    EXPECT_THROW(compare_rgb(image, grey), InputError);
}

}  // namespace
}  // namespace dewbow
