// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "aliasing/dispersed_source.h"
#include "aliasing/prisms.h"

namespace dewbow::bench {
namespace {

double distance(const Colour<Opponent>& a, const Colour<Opponent>& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

TEST(DispersedSource, ClosedFormIsTheLimitOfManySamples) {
    // 1300 samples integrate piecewise linear curves by midpoints to 1e-6 of white.
    constexpr int kMany = 1300;
    constexpr double kMidpoints = 2e-6;
    for (const Sight& sight :
         {Sight{36.0, 0.5, 0.25}, Sight{300.0, 30.0, 4.7}, Sight{80.0, 400.0, 1.0}})
        for (double angle = -250.0; angle < 550.0; angle += 7.3)
            EXPECT_LT(
                distance(seen_in_the_limit(sight, angle), seen_with_samples(sight, kMany, angle)),
                kMidpoints)
                << sight.spread << " " << angle;
}

TEST(DispersedSource, AliasingFallsWithTheNumberOfSamplesAndRisesWithTheSpread) {
    const Sight sight{120.0, 32.0, 0.25};
    EXPECT_GT(aliasing(sight, 7), aliasing(sight, 13));
    EXPECT_GT(aliasing(sight, 13), 4.0 * aliasing(sight, 31));
    EXPECT_GT(aliasing({240.0, 32.0, 0.25}, 31), aliasing(sight, 31));
}

TEST(DispersedSource, WhiteHasNoNoiseAtACommonOffset) {
    constexpr double kRounding = 1e-6;
    EXPECT_LT(noise_of_white(13, true, 1, 1.0), kRounding);
    EXPECT_GT(noise_of_white(13, false, 1, 1.0), 0.5);
    EXPECT_NEAR(noise_of_white(13, false, 16, 1.0), 0.25 * noise_of_white(13, false, 1, 1.0),
                0.02 * noise_of_white(13, false, 1, 1.0));  // CIEDE2000 is not linear
}

TEST(Eye, BlursOfAChannelSumToOne) {
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (const Lobe& lobe : lobes(c)) sum += lobe.weight;
        EXPECT_NEAR(sum, 1.0, 1e-12);
    }
}

TEST(Eye, NoiseOfSmallPixelsFallsAsTheirArea) {
    // ∫ g_a g_b dA = 1 / (2π (σ_a² + σ_b²)) of two Gaussians, pixels of 1/20 of the narrowest.
    constexpr double kPixels = 1e-3;
    const double pixel = 0.05 * sharpest_arcmin();
    Matrix3 unit;
    unit[0][0] = 1.0;
    double expected = 0.0;
    for (const Lobe& a : lobes(0))
        for (const Lobe& b : lobes(0))
            expected += a.weight * b.weight * pixel * pixel /
                        (2.0 * std::numbers::pi *
                         (a.sigma_arcmin * a.sigma_arcmin + b.sigma_arcmin * b.sigma_arcmin));
    EXPECT_NEAR(seen_covariance(unit, pixel)[0][0] / expected, 1.0, kPixels);
    // A pixel that fills the eye's view is seen as it is.
    EXPECT_NEAR(seen_covariance(unit, 1e4)[0][0], 1.0, kPixels);
}

TEST(Prisms, SpreadIsThatOfSmallSlopes) {
    // dD/dn = 2 sin(A/2) / cos i at minimum deviation; the next term is of third order.
    constexpr double kSlope = 1e-3;
    const double n = 1.5 + 0.5 * kSlope, incidence = std::asin(0.5 * n);
    const double expected = kSlope / std::cos(incidence) * 180.0 * 60.0 / std::numbers::pi;
    EXPECT_NEAR(*spread_arcmin(1.5, kSlope, 60.0 * unit::deg) / expected, 1.0, 1e-5);
    EXPECT_FALSE(spread_arcmin(1.7, 0.6, 60.0 * unit::deg));
}

}  // namespace
}  // namespace dewbow::bench
