// SPDX-License-Identifier: Apache-2.0
#include "picture_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dewbow/base/error.h"

namespace dewbow::bench {
namespace {

constexpr double kRounding = 1e-12;

Picture even(int width, int height, Colour<LinearSrgb> colour) {
    return {width, height,
            std::vector<Colour<LinearSrgb>>(std::size_t(width) * std::size_t(height), colour)};
}
Mask all(const Picture& picture) { return Mask(picture.pixels.size(), true); }
Reference perfect(const Picture& picture) { return make_reference(picture, picture); }

TEST(PictureErrors, OfEqualPicturesAreZero) {
    const Picture picture = even(8, 4, {{0.2, 0.4, 0.8}});
    const PictureErrors errors = Comparison(picture, perfect(picture)).errors(all(picture));
    for (const ErrorKind& kind : error_kinds()) EXPECT_EQ(errors.*kind.value, 0.0) << kind.name;
}

TEST(PictureErrors, AreTheMeansThatTheyAreSaidToBe) {
    const Picture reference = even(10, 10, {{0.5, 0.5, 0.5}});
    Picture picture = reference;
    picture.pixels[7] = {{0.5, 0.9, 0.5}};
    const PictureErrors errors = Comparison(picture, perfect(reference)).errors(all(picture));
    const double mse = 0.16 / 300.0;
    EXPECT_NEAR(errors.mse, mse, kRounding);
    EXPECT_NEAR(errors.relative_mse, mse / (0.25 + kFloor * kFloor), kRounding);
    // The middle column of sRGB's matrix: X, Y, Z of the green primary.
    const double green = 0.357584 * 0.357584 + 0.715169 * 0.715169 + 0.119195 * 0.119195;
    EXPECT_NEAR(errors.xyz_mse, mse * green, 1e-6 * mse);
    EXPECT_GT(errors.flip, 0.0);
}

TEST(PictureErrors, TrimmedLeavesOutTheWorstThousandth) {
    const Picture reference = even(50, 40, {{0.5, 0.5, 0.5}});
    Picture picture = even(50, 40, {{0.6, 0.6, 0.6}});
    const double expected = Comparison(picture, perfect(reference)).errors(all(picture)).trimmed;
    picture.pixels[3] = picture.pixels[900] = {{1e6, 0.0, 0.0}};  // two of 2000
    EXPECT_NEAR(Comparison(picture, perfect(reference)).errors(all(picture)).trimmed, expected,
                kRounding);
    picture.pixels[5] = {{1e6, 0.0, 0.0}};
    EXPECT_GT(Comparison(picture, perfect(reference)).errors(all(picture)).trimmed, 1.0);
}

TEST(PictureErrors, CountOnlyTheMask) {
    const Picture reference = even(4, 4, {{0.5, 0.5, 0.5}});
    Picture picture = reference;
    picture.pixels[0] = {{1.0, 1.0, 1.0}};
    Mask mask(16, false);
    mask[0] = true;
    EXPECT_NEAR(Comparison(picture, perfect(reference)).errors(mask).mse, 0.25, kRounding);
    mask.flip();
    EXPECT_EQ(Comparison(picture, perfect(reference)).errors(mask).mse, 0.0);
    EXPECT_EQ(Comparison(picture, perfect(reference)).errors(Mask(16, false)).flip, 0.0);
}

// Halves at ±e around the truth: their difference says that the mean is e² off, which is more than
// it is here; of noise that is independent in both it is right, and the expected error of the mean.
TEST(PictureErrors, TheReferencesOwnErrorIsTakenAway) {
    const Picture first = even(8, 8, {{0.6, 0.6, 0.6}}), second = even(8, 8, {{0.4, 0.4, 0.4}});
    const Reference reference = make_reference(first, second);
    const Mask mask(64, true);
    EXPECT_NEAR(own_errors(reference, mask).mse, 0.01, kRounding);
    const Picture picture = even(8, 8, {{0.8, 0.8, 0.8}});
    EXPECT_NEAR(Comparison(picture, reference).errors(mask).mse, 0.09 - 0.01, kRounding);
    EXPECT_EQ(Comparison(reference.mean, reference).errors(mask).mse, 0.0);
}

TEST(PictureErrors, WhatIsNotFiniteIsInfinitelyWrong) {
    const Picture reference = even(4, 4, {{0.5, 0.5, 0.5}});
    Picture picture = reference;
    picture.pixels[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isinf(Comparison(picture, perfect(reference)).errors(all(picture)).mse));
}

TEST(PictureErrors, PicturesOfDifferentSizesAreRefused) {
    EXPECT_THROW(Comparison(even(2, 2, {}), perfect(even(4, 1, {}))), InputError);
}

TEST(Masks, ColouredIsWhereChannelsDifferAndItIsNotDark) {
    Picture picture = even(2, 2, {{0.5, 0.5, 0.5}});
    picture.pixels[1] = {{0.5, 0.4, 0.5}};
    picture.pixels[2] = {{0.01, 0.0, 0.0}};
    picture.pixels[3] = {{0.5, 0.49, 0.5}};
    const auto masks = make_masks(picture);
    EXPECT_EQ(masks[0].mask, Mask(4, true));
    EXPECT_EQ(masks[1].mask, (Mask{false, true, false, false}));
}

}  // namespace
}  // namespace dewbow::bench
