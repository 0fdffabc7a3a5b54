// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/root_finding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace dewbow {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TEST(FindRoot, SmoothFunctionsToTheLastDigits) {
    const auto half = [](double x) { return std::cos(x) - 0.5; };
    EXPECT_NEAR(find_root(half, 0.0, 3.0).value(), std::numbers::pi / 3.0, 4 * kEpsilon);
    EXPECT_NEAR(find_root(half, 3.0, 0.0).value(), std::numbers::pi / 3.0, 4 * kEpsilon);
    const auto square = [](double x) { return x * x - 2.0; };
    EXPECT_NEAR(find_root(square, 0.0, 2.0).value(), std::numbers::sqrt2, 8 * kEpsilon);
    EXPECT_NEAR(find_root(square, 0.0, 1e9).value(), std::numbers::sqrt2, 8 * kEpsilon);
}

TEST(FindRoot, HardFunctions) {
    // Flat, steep, of high multiplicity, and with its zero at zero.
    EXPECT_NEAR(find_root([](double x) { return std::pow(x - 1.0, 9); }, 0.0, 3.0, 1e-9).value(),
                1.0, 1e-9);
    EXPECT_NEAR(find_root([](double x) { return std::exp(x) - 1e-5; }, -100.0, 100.0).value(),
                std::log(1e-5), 1e-13);
    EXPECT_NEAR(find_root([](double x) { return std::atan(1e9 * (x - 0.3)); }, 0.0, 1.0).value(),
                0.3, 4 * kEpsilon);
    EXPECT_NEAR(find_root([](double x) { return std::cbrt(x); }, -1.0, 2.0, 1e-12).value(), 0.0,
                1e-12);
    EXPECT_EQ(find_root([](double x) { return x; }, -1.0, 3.0).value(), 0.0);
    EXPECT_LE(std::abs(find_root([](double x) { return x * x * x; }, -1.0, 3.0).value()), 1e-100);
    // A step.
    EXPECT_NEAR(find_root([](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0.0, 1.0).value(), 0.7,
                4 * kEpsilon);
}

TEST(FindRoot, ToleranceIsKeptAndSavesCalls) {
    int calls = 0;
    const auto f = [&](double x) { return ++calls, std::exp(x) - 2.0; };
    EXPECT_NEAR(find_root(f, 0.0, 10.0, 1e-3).value(), std::numbers::ln2, 1e-3);
    const int coarse = calls;
    calls = 0;
    EXPECT_NEAR(find_root(f, 0.0, 10.0).value(), std::numbers::ln2, 4 * kEpsilon);
    EXPECT_LT(coarse, calls);
    // Bisection alone would take 55.
    EXPECT_LE(calls, 20);
}

TEST(FindRoot, EndsCountAndSoDoesTheirSign) {
    const auto f = [](double x) { return x - 1.0; };
    EXPECT_EQ(find_root(f, 1.0, 2.0), 1.0);
    EXPECT_EQ(find_root(f, 0.0, 1.0), 1.0);
    EXPECT_FALSE(find_root(f, 2.0, 3.0));
    EXPECT_FALSE(find_root(f, -3.0, 0.0));
}

TEST(FindRoot, NoAnswerFromNoNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(find_root([&](double) { return nan; }, 0.0, 1.0));
    EXPECT_FALSE(find_root([&](double x) { return x == 0.5 ? nan : x - 0.4; }, 0.0, 1.0));
    EXPECT_FALSE(find_root([](double x) { return x; }, -infinity, 1.0));
    EXPECT_FALSE(find_root([](double x) { return x; }, -1.0, nan));
    // Infinite values are values.
    EXPECT_NEAR(find_root([](double x) { return std::log(x); }, 0.0, 3.0).value(), 1.0, 1e-15);
}

}  // namespace
}  // namespace dewbow
