// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/learnt_density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dewbow::caustics {
namespace {

using Box = LearntDensity::Box;

// A handful of roundings of numbers near 1.
constexpr double kRounding = 1e-13;

/// Cells of a grid that the cuts below fall onto, along each axis but the last.
constexpr int kGrid = 4;

/// Leaves, by hand: x0 < 1/2 holds 1 part; of the rest x3 < 1/4 holds 6 and x3 ≥ 1/4 cut at x1 =
/// 1/2 into 0 and 3.
LearntDensity make_by_hand() {
    return LearntDensity({{0, 0.5, 2, 0},
                          {-1, 0, 0, 1},
                          {3, 0.25, 4, 0},
                          {-1, 0, 0, 6},
                          {1, 0.5, 6, 0},
                          {-1, 0, 0, 0},
                          {-1, 0, 0, 3}});
}

/// A tree of cuts at halves, and masses over six powers of ten.
LearntDensity make_random(int depth) {
    std::mt19937_64 random(5);
    std::vector<Box> boxes;
    const auto grow = [&](const auto& self, std::array<double, 10> room, int level) -> void {
        const std::size_t here = boxes.size();
        boxes.emplace_back();
        if (level == depth) {
            boxes[here].mass = std::uint64_t(std::pow(10.0, double(random() % 7000) / 1000.0));
            return;
        }
        const auto axis = std::size_t(random() % kAimDimensions);
        boxes[here].axis = int(axis);
        boxes[here].cut = 0.5 * (room[2 * axis] + room[2 * axis + 1]);
        auto half = room;
        half[2 * axis + 1] = boxes[here].cut;
        self(self, half, level + 1);
        boxes[here].second = std::uint32_t(boxes.size());
        half = room;
        half[2 * axis] = boxes[here].cut;
        self(self, half, level + 1);
    };
    grow(grow, {0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, 0);
    return LearntDensity(boxes);
}

AimPoint random_point(std::mt19937_64& random) {
    AimPoint u;
    for (double& x : u) x = double(random() >> 11) * 0x1p-53;
    return u;
}

TEST(LearntDensity, IsUniformBeforeItHasLearnt) {
    const LearntDensity density;
    const AimPoint u{0.1, 0.2, 0.3, 0.4, 0.999};
    EXPECT_EQ(density.sample(u).at, u);
    EXPECT_EQ(density.sample(u).density, 1.0);
    EXPECT_EQ(density.density(u), 1.0);
    EXPECT_EQ(density.leaves(), 1u);
}

TEST(LearntDensity, IsUniformIfNothingWasFound) {
    const LearntDensity density({{0, 0.5, 2, 0}, {}, {}});
    EXPECT_EQ(density.density({0.1, 0, 0, 0, 0}), 1.0);
    EXPECT_EQ(density.density({0.9, 0, 0, 0, 0}), 1.0);
}

TEST(LearntDensity, HoldsMassesAndATenthThatIsUniform) {
    const LearntDensity density = make_by_hand();
    EXPECT_NEAR(density.density({0.1, 0.9, 0, 0.9, 0}), 0.1 + 0.9 * 0.1 / 0.5, kRounding);
    EXPECT_NEAR(density.density({0.5, 0.9, 0, 0.2, 0}), 0.1 + 0.9 * 0.6 / 0.125, kRounding);
    EXPECT_NEAR(density.density({0.9, 0.4, 0, 0.25, 0}), 0.1, kRounding);
    EXPECT_NEAR(density.density({0.9, 0.5, 0, 0.9, 0}), 0.1 + 0.9 * 0.3 / 0.1875, kRounding);
}

// Midpoints of a grid as fine as the cuts: the sum is the integral.
TEST(LearntDensity, IntegratesToOne) {
    const LearntDensity density = make_random(4);
    constexpr int kFine = 16;  // 4 cuts of one axis
    double sum = 0.0;
    AimPoint at;
    const auto add = [&](const auto& self, std::size_t axis) -> void {
        if (axis == kAimDimensions) {
            sum += density.density(at);
            return;
        }
        for (int i = 0; i < kFine; ++i) at[axis] = (i + 0.5) / kFine, self(self, axis + 1);
    };
    add(add, 0);
    EXPECT_NEAR(sum / std::pow(kFine, kAimDimensions), 1.0, 1e-10);  // a million roundings
}

TEST(LearntDensity, ASampleKnowsTheDensityThatIsThere) {
    const LearntDensity density = make_random(9);
    std::mt19937_64 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const LearntDensity::Sample sample = density.sample(random_point(random));
        ASSERT_EQ(sample.density, density.density(sample.at));
        ASSERT_GE(sample.density, kUniformShare * (1.0 - kRounding));
        for (const double x : sample.at) ASSERT_TRUE(x >= 0.0 && x < 1.0) << x;
    }
}

// Chi-square of 10⁶ samples over 4⁴ × 2 cells whose probabilities come from density() alone, in
// standard deviations from its mean.
double excess_of_samples(const LearntDensity& sampled, const LearntDensity& evaluated) {
    constexpr int kSamples = 1'000'000;
    constexpr int kCells = kGrid * kGrid * kGrid * kGrid * 2;
    std::vector<double> expected(kCells), found(kCells);
    const auto cell_of = [](const AimPoint& at) {
        int cell = int(at[4] * 2);
        for (std::size_t axis = 0; axis < 4; ++axis) cell = cell * kGrid + int(at[axis] * kGrid);
        return std::size_t(cell);
    };
    std::mt19937_64 random(2);
    for (int i = 0; i < kSamples; ++i) ++found[cell_of(sampled.sample(random_point(random)).at)];
    AimPoint at;
    const auto add = [&](const auto& self, std::size_t axis) -> void {
        constexpr int kFine = 8;
        if (axis == kAimDimensions) {
            expected[cell_of(at)] += kSamples * evaluated.density(at) / std::pow(kFine, 5);
            return;
        }
        for (int i = 0; i < kFine; ++i) at[axis] = (i + 0.5) / kFine, self(self, axis + 1);
    };
    add(add, 0);
    double chi2 = 0.0;
    for (int i = 0; i < kCells; ++i) {
        const auto k = std::size_t(i);
        chi2 += (found[k] - expected[k]) * (found[k] - expected[k]) / expected[k];
    }
    return (chi2 - (kCells - 1)) / std::sqrt(2.0 * (kCells - 1));
}

// With 511 degrees of freedom chi-square is nearly normal: one in 10⁴ seeds is beyond this.
constexpr double kFalseAlarm = 3.9;

TEST(LearntDensity, SamplesFollowIt) {
    const LearntDensity density = make_random(3);
    EXPECT_LT(excess_of_samples(density, density), kFalseAlarm);
}

// Power of the test above: a mass of two that is 3 % too large is found.
TEST(LearntDensity, SamplesOfAnotherDensityAreFound) {
    const auto with_mass = [](std::uint64_t mass) {
        return LearntDensity({{0, 0.5, 2, 0}, {-1, 0, 0, mass}, {-1, 0, 0, 100}});
    };
    EXPECT_GT(excess_of_samples(with_mass(103), with_mass(100)), kFalseAlarm);
}

// Of n evenly spaced numbers a leaf of probability P gets n P to within one: along the axis that is
// cut nothing is lost of their evenness.
TEST(LearntDensity, EvenNumbersStayEven) {
    const LearntDensity density({{2, 0.5, 4, 0},
                                 {2, 0.25, 3, 0},
                                 {-1, 0, 0, 5},
                                 {-1, 0, 0, 1},
                                 {2, 0.75, 6, 0},
                                 {-1, 0, 0, 90},
                                 {-1, 0, 0, 4}});
    constexpr int kNumbers = 1000;
    std::array<int, 4> count{};
    double last = -1.0;
    for (int i = 0; i < kNumbers; ++i) {
        const double x = density.sample({0, 0, (i + 0.5) / kNumbers, 0, 0}).at[2];
        EXPECT_GT(x, last);  // in order
        last = x;
        ++count[std::size_t(x * 4)];
    }
    for (int leaf = 0; leaf < 4; ++leaf)
        EXPECT_NEAR(count[std::size_t(leaf)],
                    kNumbers * density.density({0, 0, (leaf + 0.5) / 4, 0, 0}) / 4, 1.0);
}

}  // namespace
}  // namespace dewbow::caustics
