// SPDX-License-Identifier: Apache-2.0
#include "contact_sheet.h"

#include <gtest/gtest.h>

#include "small_letters.h"

namespace dewbow::bench {
namespace {

int red(const Image8& image, int x, int y) {
    return image.rgb[std::size_t(3 * (y * image.width + x))];
}

TEST(ContactSheet, ShowsTheTruthFirstAndThenEachResult) {
    Measurements all;
    SceneFacts scene;
    scene.name = "disc";
    scene.truth = {2, 1, {{{1.0, 1.0, 1.0}}, {{-0.5, 0.0, 0.0}}}};
    all.scenes.push_back(scene);
    Result result{"disc", "path", {0, 4, 0}};
    result.errors = {{"whole", {}, std::nullopt}};
    result.picture = {2, 1, {{{0.0, 0.0, 0.0}}, {{9.0, 9.0, 9.0}}}};
    all.results.push_back(result);
    const Image8 sheet = contact_sheet(all);
    // Two pixels of 96 in a cell of 192, 8 from the edges and from each other.
    EXPECT_EQ(red(sheet, 8, 8), 255);
    EXPECT_EQ(red(sheet, 8 + 95, 8 + 95), 255);
    EXPECT_EQ(red(sheet, 8 + 96, 8), 0);
    EXPECT_EQ(red(sheet, 8 + 192 + 8, 8), 0);
    EXPECT_EQ(red(sheet, 8 + 192 + 8 + 96, 8), 255);
}

TEST(SmallLetters, AreWhereTheyShouldBe) {
    Image8 image{8, 9, std::vector<std::uint8_t>(8 * 9 * 3, 0)};
    put_letters(image, "l?L", 1, 1, 200);
    for (int y = 1; y <= kLetterHeight; ++y) EXPECT_EQ(red(image, 1, y), 200);
    for (int x = 1; x <= kLetterWidth; ++x) EXPECT_EQ(red(image, x, kLetterHeight), 200);
    EXPECT_EQ(red(image, 2, 1), 0);
    EXPECT_EQ(red(image, 0, 1), 0);
    EXPECT_EQ(red(image, 7, 1), 0);
}

}  // namespace
}  // namespace dewbow::bench
