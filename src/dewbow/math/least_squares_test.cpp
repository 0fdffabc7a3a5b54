// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/least_squares.h"

#include <gtest/gtest.h>

namespace dewbow {
namespace {

constexpr double kRounding = 1e-13;

/// 1, x, x² … at `x`, by columns.
std::vector<double> powers(const std::vector<double>& x, std::size_t columns) {
    std::vector<double> a;
    for (std::size_t k = 0; k < columns; ++k)
        for (const double at : x) a.push_back(std::pow(at, double(k)));
    return a;
}

TEST(LeastSquares, GoesThroughWhatCanBeMet) {
    const std::vector<double> x{-1.0, 0.5, 2.0, 3.0};
    std::vector<double> b;
    for (const double at : x) b.push_back(1.0 - 2.0 * at + 3.0 * at * at);
    const std::vector<double> c = least_squares(powers(x, 3), b);
    ASSERT_EQ(c.size(), 3u);
    EXPECT_NEAR(c[0], 1.0, kRounding);
    EXPECT_NEAR(c[1], -2.0, kRounding);
    EXPECT_NEAR(c[2], 3.0, kRounding);
}

// The line through (0, 1), (1, 3), (2, 4), (3, 4): slope Σ(x−x̄)(y−ȳ)/Σ(x−x̄)² = 5/5, mean 3 at 1.5.
TEST(LeastSquares, GivesTheLineOfRegression) {
    const std::vector<double> c =
        least_squares(powers({0.0, 1.0, 2.0, 3.0}, 2), std::vector<double>{1.0, 3.0, 4.0, 4.0});
    EXPECT_NEAR(c[0], 1.5, kRounding);
    EXPECT_NEAR(c[1], 1.0, kRounding);
}

// What is left is at right angles to every column.
TEST(LeastSquares, LeavesWhatNoColumnHas) {
    std::vector<double> x, b;
    for (int i = 0; i < 40; ++i)
        x.push_back(0.38 + 0.01 * i), b.push_back(std::sin(9.0 * x.back()));
    const std::vector<double> a = powers(x, 4), c = least_squares(a, b);
    for (std::size_t k = 0; k < 4; ++k) {
        double product = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            double left = b[i];
            for (std::size_t j = 0; j < 4; ++j) left -= a[j * x.size() + i] * c[j];
            product += a[k * x.size() + i] * left;
        }
        EXPECT_NEAR(product, 0.0, kRounding * 40);
    }
}

TEST(LeastSquares, LeavesOutAColumnThatSaysNothingNew) {
    const std::vector<double> a{1.0, 1.0, 1.0, 2.0, 2.0, 2.0};
    const std::vector<double> c = least_squares(a, std::vector<double>{1.0, 2.0, 6.0});
    EXPECT_NEAR(c[0], 3.0, kRounding);
    EXPECT_EQ(c[1], 0.0);
}

TEST(FindMinimum, FindsTheBottom) {
    constexpr double kFlat = 1e-7;  // f changes by less than its rounding nearer to the bottom
    EXPECT_NEAR(find_minimum([](double x) { return (x - 0.3) * (x - 0.3); }, -1.0, 2.0), 0.3,
                kFlat);
    EXPECT_NEAR(find_minimum([](double x) { return std::abs(x - 1.7); }, 0.0, 2.0), 1.7, kFlat);
    EXPECT_NEAR(find_minimum([](double x) { return x; }, 1.0, 2.0), 1.0, kFlat);
}

}  // namespace
}  // namespace dewbow
