// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <vector>

namespace dewbow {
namespace {

// A handful of roundings of numbers of size 1.
constexpr double kRounding = 1e-14;
constexpr double kOneBelow = 1.0 - 0x1p-53;

std::vector<double> random_weights(std::size_t count) {
    std::mt19937_64 random(count);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> weights(count);
    for (double& w : weights) w = uniform(random) < 0.3 ? 0.0 : uniform(random);
    weights[count / 2] = 1.0;
    return weights;
}

TEST(Distribution1DTest, DensityIsInProportionToTheWeights) {
    const std::vector<double> weights{1.0, 0.0, 3.0, 4.0};
    const Distribution1D d(weights);
    EXPECT_EQ(d.size(), 4u);
    EXPECT_DOUBLE_EQ(d.total(), 8.0);
    EXPECT_FALSE(d.was_all_zero());
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_DOUBLE_EQ(d.probability(i), weights[i] / 8.0);
        EXPECT_DOUBLE_EQ(d.pdf(i), weights[i] / 2.0);
    }
}

TEST(Distribution1DTest, SampleAtKnownPlaces) {
    const Distribution1D d(std::vector<double>{1.0, 0.0, 3.0, 4.0});
    const auto expect = [&](double u, std::size_t index, double offset) {
        const Distribution1D::Sample s = d.sample(u);
        EXPECT_EQ(s.index, index) << u;
        EXPECT_NEAR(s.offset, offset, kRounding) << u;
        EXPECT_EQ(s.pdf, d.pdf(index)) << u;
    };
    expect(0.0, 0, 0.0);
    expect(0.0625, 0, 0.5);
    expect(0.125, 2, 0.0);  // the empty cell is passed over
    expect(0.3125, 2, 0.5);
    expect(0.5, 3, 0.0);
    expect(0.75, 3, 0.5);
    expect(kOneBelow, 3, 1.0);
}

TEST(Distribution1DTest, CdfUndoesSampleAndSampleUndoesCdf) {
    for (const std::size_t n : {1u, 2u, 7u, 100u, 10'000u}) {
        const Distribution1D d(random_weights(n));
        for (int i = 0; i < 1000; ++i) {
            const double u = (i + 0.5) / 1000.0;
            const Distribution1D::Sample s = d.sample(u);
            const double x = (static_cast<double>(s.index) + s.offset) / static_cast<double>(n);
            ASSERT_NEAR(d.cdf(x), u, kRounding);
            ASSERT_GT(s.pdf, 0.0);

            // Within a cell: at the end of one before an empty one, F has no inverse.
            const auto cell = static_cast<std::size_t>(u * static_cast<double>(n));
            if (d.probability(cell) == 0.0) continue;
            const double inside = (static_cast<double>(cell) + 0.37) / static_cast<double>(n);
            const Distribution1D::Sample back = d.sample(d.cdf(inside));
            ASSERT_EQ(back.index, cell);
            // An error of F counts as one over the probability of the cell.
            ASSERT_NEAR(back.offset, 0.37, kRounding * (1.0 + 1.0 / d.probability(cell)));
        }
        EXPECT_EQ(d.cdf(0.0), 0.0);
        EXPECT_EQ(d.cdf(1.0), 1.0);
        EXPECT_EQ(d.cdf(-5.0), 0.0);
        EXPECT_EQ(d.cdf(7.0), 1.0);
    }
}

// The cell is found by a guide; looking at all of them from the first must give the same.
TEST(Distribution1DTest, FindsTheCellThatALookAtAllOfThemFinds) {
    const std::vector<std::vector<double>> tables{
        {1}, {1, 2, 3}, {0, 0, 1, 0}, {1e-9, 1, 1e-9, 0, 0, 5, 1e-12}, std::vector(500, 0.3)};
    for (const std::vector<double>& weights : tables) {
        const Distribution1D d(weights);
        std::vector<double> low{0.0};  // where the cells begin
        for (std::size_t i = 1; i < d.size(); ++i)
            low.push_back(d.cdf(double(i) / double(d.size())));
        std::vector<double> places;
        for (const double edge : low)
            places.insert(places.end(),
                          {std::nextafter(edge, 0.0), edge, std::nextafter(edge, 1.0)});
        for (int i = 0; i < 64; ++i) places.push_back(i / 64.0);
        for (const double u : places) {
            if (u >= 1.0) continue;
            std::size_t expected = 0;
            while (expected + 1 < low.size() && low[expected + 1] <= u) ++expected;
            EXPECT_EQ(d.sample(u).index, expected) << "of " << weights.size() << " at " << u;
        }
    }
}

TEST(Distribution1DTest, EmptyCellsAtTheEndsAreNeverChosen) {
    const Distribution1D d(std::vector<double>{0.0, 0.0, 0.1, 0.2, 0.7, 0.0, 0.0});
    EXPECT_EQ(d.sample(0.0).index, 2u);
    EXPECT_EQ(d.sample(kOneBelow).index, 4u);
    EXPECT_EQ(d.sample(1.0).index, 4u);  // out of contract, but not out of bounds
    EXPECT_LT(d.sample(kOneBelow).offset, 1.0);
}

TEST(Distribution1DTest, WeightsTooSmallToCountHaveNoDensity) {
    const Distribution1D d(std::vector<double>{1.0, 1e-30, 1.0});
    EXPECT_EQ(d.pdf(1), 0.0);
    EXPECT_EQ(d.sample(0.5).index, 2u);
}

TEST(Distribution1DTest, ExtremeWeights) {
    for (const double scale : {5e-324, 1e-300, 1e307}) {
        const Distribution1D d(std::vector<double>{scale, 3.0 * scale});
        EXPECT_DOUBLE_EQ(d.probability(1), 0.75) << scale;
    }
}

TEST(Distribution1DTest, AllZeroIsUniformAndSaysSo) {
    const Distribution1D d(std::vector<double>(5, 0.0));
    EXPECT_TRUE(d.was_all_zero());
    EXPECT_EQ(d.total(), 0.0);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(d.pdf(i), 1.0, kRounding);
    EXPECT_EQ(d.sample(0.5).index, 2u);
}

TEST(DistributionDeathTest, WrongWeights) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto make = [](std::vector<double> weights) { Distribution1D{weights}; };
    const auto aborts = testing::KilledBySignal(SIGABRT);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EXIT(make({}), aborts, "has a cell");
    EXPECT_EXIT(make({1.0, -1.0}), aborts, "not negative");
    EXPECT_EXIT(make({1.0, infinity}), aborts, "finite");
    EXPECT_EXIT(make({1.0, infinity - infinity}), aborts, "finite");
    EXPECT_EXIT(Distribution2D(std::vector<double>(5), 2, 3), aborts, "a weight for each cell");
    EXPECT_EXIT(Distribution2D(std::vector<double>(), 0, 3), aborts, "a weight for each cell");
}

TEST(Distribution2DTest, DensityIsInProportionToTheWeights) {
    const std::vector<double> weights{1, 2, 3,  //
                                      0, 0, 0,  //
                                      4, 0, 0,  //
                                      0, 6, 8};
    const Distribution2D d(weights, 3, 4);
    EXPECT_DOUBLE_EQ(d.total(), 24.0);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
            const double px = (static_cast<double>(x) + 0.5) / 3.0;
            const double py = (static_cast<double>(y) + 0.5) / 4.0;
            EXPECT_NEAR(d.pdf(px, py), weights[3 * y + x] * 12.0 / 24.0, kRounding);
        }
    for (const auto& [x, y] : {std::pair{-0.1, 0.5}, {1.0, 0.5}, {0.5, -1e-9}, {0.5, 1.0}})
        EXPECT_EQ(d.pdf(x, y), 0.0);
}

TEST(Distribution2DTest, SamplesLieWhereTheirDensitySays) {
    const std::size_t width = 13, height = 7;
    const Distribution2D d(random_weights(width * height), width, height);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 10'000; ++i) {
        const Distribution2D::Sample s = d.sample(uniform(random), uniform(random));
        ASSERT_TRUE(s.x >= 0.0 && s.x < 1.0 && s.y >= 0.0 && s.y < 1.0);
        ASSERT_GT(s.pdf, 0.0);
        ASSERT_DOUBLE_EQ(s.pdf, d.pdf(s.x, s.y));
    }
    const Distribution2D::Sample last = d.sample(kOneBelow, kOneBelow);
    EXPECT_LT(last.x, 1.0);
    EXPECT_LT(last.y, 1.0);
}

TEST(Distribution2DTest, MeansAreThoseOfTheWeights) {
    // The mean of (x, y, xy) over the samples of a regular grid is the weighted mean over the
    // cells, since the map is linear in each cell: exact but for cells that grid lines cut, which
    // 1/1000 bounds.
    const std::size_t width = 3, height = 2;
    const std::vector<double> weights{1, 0, 3, 2, 2, 0};
    const Distribution2D d(weights, width, height);
    double x = 0.0, y = 0.0, xy = 0.0, expected_x = 0.0, expected_y = 0.0, expected_xy = 0.0;
    constexpr int kGrid = 1000;
    for (int i = 0; i < kGrid; ++i)
        for (int j = 0; j < kGrid; ++j) {
            const Distribution2D::Sample s = d.sample((i + 0.5) / kGrid, (j + 0.5) / kGrid);
            x += s.x / (kGrid * kGrid);
            y += s.y / (kGrid * kGrid);
            xy += s.x * s.y / (kGrid * kGrid);
        }
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double cx = (static_cast<double>(k % width) + 0.5) / width;
        const double cy = (static_cast<double>(k / width) + 0.5) / height;
        expected_x += cx * weights[k] / 8.0;
        expected_y += cy * weights[k] / 8.0;
        expected_xy += cx * cy * weights[k] / 8.0;
    }
    EXPECT_NEAR(x, expected_x, 1.0 / kGrid);
    EXPECT_NEAR(y, expected_y, 1.0 / kGrid);
    EXPECT_NEAR(xy, expected_xy, 1.0 / kGrid);
}

TEST(Distribution2DTest, AllZeroIsUniformAndSaysSo) {
    const Distribution2D d(std::vector<double>(6, 0.0), 3, 2);
    EXPECT_TRUE(d.was_all_zero());
    EXPECT_NEAR(d.pdf(0.1, 0.9), 1.0, kRounding);
    const Distribution2D::Sample s = d.sample(0.3, 0.8);
    EXPECT_NEAR(s.x, 0.3, kRounding);
    EXPECT_NEAR(s.y, 0.8, kRounding);
    EXPECT_NEAR(s.pdf, 1.0, kRounding);
    EXPECT_FALSE(Distribution2D(std::vector<double>{0, 0, 1, 0}, 2, 2).was_all_zero());
}

TEST(Distribution2DTest, FindsBackTheNumbersOfAPoint) {
    const Distribution2D d(std::vector<double>{1, 0, 3, 2, 2, 0}, 3, 2);
    for (int i = 0; i < 100; ++i) {
        const double u0 = (i % 10 + 0.3) / 10.0, u1 = (i / 10 + 0.6) / 10.0;
        const Distribution2D::Sample s = d.sample(u0, u1);
        const auto back = d.inverse(s.x, s.y);
        EXPECT_NEAR(back[0], u0, kRounding);
        EXPECT_NEAR(back[1], u1, kRounding);
    }
}

}  // namespace
}  // namespace dewbow
