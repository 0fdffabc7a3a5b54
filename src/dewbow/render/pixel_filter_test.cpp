// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/pixel_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

namespace dewbow {
namespace {

/// The filter's table has 500 cells: the variance of a step within a cell is 1/12 of its square.
constexpr double kTable = 1e-5;

struct Moments {
    double mean = 0.0, variance = 0.0;
};
Moments sampled(const PixelFilter& filter) {
    const FilterSampler sampler(filter);
    constexpr int kCount = 200000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double x = sampler.sample((i + 0.5) / kCount);
        EXPECT_LE(std::abs(x), filter.radius);
        sum += x, squares += x * x;
    }
    return {sum / kCount, squares / kCount - sum * sum / kCount / kCount};
}

TEST(PixelFilter, FiltersHaveTheirVariance) {
    const Moments box = sampled({FilterKind::box, 0.5});
    EXPECT_NEAR(box.mean, 0.0, kTable);
    EXPECT_NEAR(box.variance, 0.25 / 3.0, kTable);
    // A Gaussian cut at three standard deviations: 1 − 6 φ(3) / (2 Φ(3) − 1).
    const Moments gaussian = sampled({FilterKind::gaussian, 1.5});
    const double phi = std::exp(-4.5) / std::sqrt(2.0 * std::numbers::pi);
    EXPECT_NEAR(gaussian.mean, 0.0, kTable);
    EXPECT_NEAR(gaussian.variance, 0.25 * (1.0 - 6.0 * phi / std::erf(3.0 / std::sqrt(2.0))),
                kTable);
    // Σ a_j cos(j π (x + 1)): ∫ x² cos(jπ(x+1)) = 4 / (jπ)² over [−1, 1], and 2/3 for j = 0.
    const Moments harris = sampled({FilterKind::blackman_harris, 1.5});
    const double a[] = {0.35875, -0.48829, 0.14128, -0.01168};
    double second = a[0] * 2.0 / 3.0;
    for (int j = 1; j < 4; ++j) second += a[j] * 4.0 / std::pow(j * std::numbers::pi, 2.0);
    EXPECT_NEAR(harris.mean, 0.0, kTable);
    EXPECT_NEAR(harris.variance, 2.25 * second / (2.0 * a[0]), 2.0 * kTable);
}

// The density is that of the samples: what lies below x is what numbers below u are taken to.
TEST(PixelFilter, DensityIsThatOfSamples) {
    constexpr double kRounding = 1e-11;  // of a sum over 50,000 steps
    for (const PixelFilter& filter :
         {PixelFilter{FilterKind::box, 0.5}, PixelFilter{FilterKind::gaussian, 1.5},
          PixelFilter{FilterKind::blackman_harris, 2.0}}) {
        const FilterSampler sampler(filter);
        // Steps of a hundredth of a cell, so that none lies on an edge.
        constexpr int kSteps = 50000;
        const double step = 2.0 * filter.radius / kSteps;
        std::vector<double> below{0.0};
        for (int i = 0; i < kSteps; ++i)
            below.push_back(below.back() +
                            step * sampler.density(-filter.radius + (i + 0.5) * step));
        EXPECT_NEAR(below.back(), 1.0, kRounding);
        for (const double u : {0.001, 0.2, 0.5, 0.77, 0.9999}) {
            const double at = (sampler.sample(u) + filter.radius) / step;
            const auto i = std::size_t(at);
            EXPECT_NEAR(below[i] + (at - double(i)) * (below[i + 1] - below[i]), u, kRounding);
        }
        EXPECT_EQ(sampler.density(1.0001 * filter.radius), 0.0);
        EXPECT_EQ(sampler.density(-1.0001 * filter.radius), 0.0);
    }
}

TEST(PixelFilter, ReachesThePixelsWhoseSamplesCanLieThere) {
    const FilterSampler box({FilterKind::box, 0.5});
    int count = 0;
    box.for_each_cell(7.25, [&](int i, double weight) {
        EXPECT_EQ(i, 7);
        EXPECT_NEAR(weight, 1.0, 1e-12);
        ++count;
    });
    EXPECT_EQ(count, 1);
    const FilterSampler wide({FilterKind::box, 1.5});
    std::vector<int> reached;
    wide.for_each_cell(-0.25, [&](int i, double) { reached.push_back(i); });
    EXPECT_EQ(reached, (std::vector<int>{-2, -1, 0}));
}

}  // namespace
}  // namespace dewbow
