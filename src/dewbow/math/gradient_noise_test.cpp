// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/gradient_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewbow {
namespace {

TEST(GradientNoise, IsZeroOnTheLattice) {
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j)
            EXPECT_EQ(gradient_noise({double(i), double(j), 7.0 * i - j}, 5), 0.0);
}

// In the middle of a cell eight independent ramps meet with weight 1/8; each has mean 0 and
// variance Σ E[g_i²] / 4 = 1/2, whatever the table of gradients. Over N seeds the mean is off by
// more than five standard errors once in 1.7 million runs; so is the variance (fourth moment ≤
// 3σ⁴).
TEST(GradientNoise, HasTheMomentsOfItsGradients) {
    constexpr int kSeeds = 40000;
    constexpr double kVariance = 1.0 / 16.0, kErrors = 5.0;
    double sum = 0.0, squares = 0.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const double n = gradient_noise({0.5, -3.5, 1000.5}, std::uint64_t(seed));
        sum += n, squares += n * n;
    }
    EXPECT_NEAR(sum / kSeeds, 0.0, kErrors * std::sqrt(kVariance / kSeeds));
    EXPECT_NEAR(squares / kSeeds, kVariance, kErrors * kVariance * std::sqrt(2.0 / kSeeds));
}

// Near a lattice point n = g·d + O(d³): the same ramp in all eight cells around it, so the noise
// and its first two derivatives are continuous there.
TEST(GradientNoise, IsOneRampAroundALatticePoint) {
    constexpr double kStep = 1e-3, kThirdOrder = 200.0 * kStep * kStep * kStep;
    const Vec3 point{4.0, -2.0, 9.0};
    const auto at = [&](Vec3 d) { return gradient_noise(point + d * kStep, 77); };
    const Vec3 g{at({1, 0, 0}), at({0, 1, 0}), at({0, 0, 1})};
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0})
                EXPECT_NEAR(at({x, y, z}), dot(g, {x, y, z}), kThirdOrder);
    EXPECT_NEAR(dot(g, g) / (kStep * kStep), 2.0, kThirdOrder / kStep);  // gradients are √2 long
}

TEST(GradientNoise, StaysInRangeAndFollowsItsSeed) {
    double most = 0.0;
    for (int i = 0; i < 20000; ++i)
        most = std::max(most, std::abs(gradient_noise({0.37 * i, 0.71 * i, -0.13 * i}, 3)));
    EXPECT_GT(most, 0.5);
    EXPECT_LT(most, 1.04);
    EXPECT_NE(gradient_noise({0.3, 0.4, 0.5}, 1), gradient_noise({0.3, 0.4, 0.5}, 2));
}

}  // namespace
}  // namespace dewbow
