// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr int kWidth = 40, kHeight = 24;
/// The authors' program, whose numbers stand below, works in float and rounds the matrices of sRGB:
/// greys that differ by a twentieth come out 4.2e-5 apart.
constexpr double kFloat = 6e-5;

template <class Rgb>
Image image_of(const Rgb& rgb) {
    Image image{kWidth, kHeight, {{"R", {}}, {"G", {}}, {"B", {}}}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::array<double, 3> colour = rgb(x, y);
            for (std::size_t c = 0; c < 3; ++c)
                image.channels[c].values.push_back(float(std::clamp(colour[c], 0.0, 1.0)));
        }
    return image;
}

Image even(double r, double g, double b) {
    return image_of([&](int, int) { return std::array{r, g, b}; });
}
std::array<double, 3> ramp(int x, int y) { return {(x + 0.5) / kWidth, (y + 0.5) / kHeight, 0.5}; }
Image chequered_ramp() {
    return image_of([](int x, int y) {
        const double step = (x + y) % 2 ? 0.3 : 0.0;
        const auto colour = ramp(x, y);
        return std::array{colour[0] + step, colour[1] - step, colour[2]};
    });
}
Image dotted_ramp() {
    return image_of([](int x, int y) {
        return x == 20 && y == 12 ? std::array{1.0, 1.0, 1.0} : ramp(x, y);
    });
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}
double at(const std::vector<double>& values, int x, int y) {
    return values[std::size_t(y * kWidth + x)];
}

TEST(Flip, EqualPicturesDoNotDiffer) {
    for (const double difference : flip(chequered_ramp(), chequered_ramp()))
        EXPECT_EQ(difference, 0.0);
}

// The paper scales by the largest difference that sRGB holds, that between green and blue.
TEST(Flip, GreenAndBlueDifferByOne) {
    for (const double difference : flip(even(0, 1, 0), even(0, 0, 1)))
        EXPECT_NEAR(difference, 1.0, 1e-12);
}

TEST(Flip, IsTheSameBothWays) {
    const auto there = flip(chequered_ramp(), dotted_ramp());
    const auto back = flip(dotted_ramp(), chequered_ramp());
    for (std::size_t i = 0; i < there.size(); ++i) EXPECT_NEAR(there[i], back[i], 1e-12);
}

// From here on the numbers are those of the authors' own FLIP.h (version 1.6) for the same
// pictures.
TEST(Flip, EvenPicturesAsTheAuthorsProgram) {
    EXPECT_NEAR(mean(flip(even(1, 1, 1), even(0, 0, 0))), 0.967394, kFloat);
    EXPECT_NEAR(mean(flip(even(0.25, 0.25, 0.25), even(0.2, 0.2, 0.2))), 0.183437, kFloat);
}

TEST(Flip, ChequersAsTheAuthorsProgram) {
    const auto differences = flip(chequered_ramp(), image_of(ramp));
    EXPECT_NEAR(mean(differences), 0.488822, kFloat);
    EXPECT_NEAR(at(differences, 5, 7), 0.622823, kFloat);
    EXPECT_NEAR(at(differences, 30, 20), 0.463334, kFloat);
    EXPECT_NEAR(at(differences, 0, 0), 0.323563, kFloat);
}

TEST(Flip, FireflyAsTheAuthorsProgram) {
    const auto differences = flip(dotted_ramp(), image_of(ramp));
    EXPECT_NEAR(mean(differences), 0.002564, kFloat);
    EXPECT_NEAR(at(differences, 20, 12), 0.207585, kFloat);
    EXPECT_NEAR(at(differences, 22, 12), 0.062562, kFloat);
    EXPECT_NEAR(at(differences, 24, 12), 0.004240, kFloat);
}

TEST(Flip, RefusesPicturesThatDoNotBelongTogether) {
    Image narrow{1, 1, {{"R", {0}}, {"G", {0}}, {"B", {0}}}};
    EXPECT_THROW(flip(narrow, even(0, 0, 0)), InputError);
    narrow.channels.pop_back();
    EXPECT_THROW(flip(narrow, narrow), InputError);
}

}  // namespace
}  // namespace dewbow
