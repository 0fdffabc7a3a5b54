// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/interpolation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <limits>
#include <vector>

namespace dewbow {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const std::vector<double> kAbscissae{1.0, 2.0, 4.0, 8.0};
const std::vector<double> kValues{10.0, 20.0, 0.0, 40.0};

TEST(IntervalOf, HoldsTheAbscissa) {
    EXPECT_EQ(interval_of(kAbscissae, -kInfinity), 0u);
    EXPECT_EQ(interval_of(kAbscissae, 0.0), 0u);
    EXPECT_EQ(interval_of(kAbscissae, 1.0), 0u);
    EXPECT_EQ(interval_of(kAbscissae, 1.9), 0u);
    EXPECT_EQ(interval_of(kAbscissae, 2.0), 1u);
    EXPECT_EQ(interval_of(kAbscissae, 3.9), 1u);
    EXPECT_EQ(interval_of(kAbscissae, 4.0), 2u);
    EXPECT_EQ(interval_of(kAbscissae, 8.0), 2u);
    EXPECT_EQ(interval_of(kAbscissae, kInfinity), 2u);
    EXPECT_EQ(interval_of(std::array{0.0, 1.0}, 5.0), 0u);
    EXPECT_LE(interval_of(kAbscissae, kNan), 2u);
}

TEST(InterpolateLinear, MeetsThePointsAndTheLinesBetween) {
    for (std::size_t i = 0; i < kAbscissae.size(); ++i)
        EXPECT_EQ(interpolate_linear(kAbscissae, kValues, kAbscissae[i]), kValues[i]);
    EXPECT_DOUBLE_EQ(interpolate_linear(kAbscissae, kValues, 1.25), 12.5);
    EXPECT_DOUBLE_EQ(interpolate_linear(kAbscissae, kValues, 3.0), 10.0);
    EXPECT_DOUBLE_EQ(interpolate_linear(kAbscissae, kValues, 5.0), 10.0);
}

TEST(InterpolateLinear, EndsGoOnAndNanStays) {
    EXPECT_EQ(interpolate_linear(kAbscissae, kValues, -kInfinity), 10.0);
    EXPECT_EQ(interpolate_linear(kAbscissae, kValues, kInfinity), 40.0);
    EXPECT_TRUE(std::isnan(interpolate_linear(kAbscissae, kValues, kNan)));
    EXPECT_EQ(interpolate_linear(std::array{3.0}, std::array{7.0}, 100.0), 7.0);
}

TEST(InterpolateLinear, AConstantStaysExact) {
    const std::array<double, 2> abscissae{0.0, 0.7}, values{0.1, 0.1};
    for (double x = 0.0; x <= 0.7; x += 0.013)
        ASSERT_EQ(interpolate_linear(abscissae, values, x), 0.1);
}

TEST(InterpolateLinearRegular, AgreesWithTheIrregularOne) {
    const std::vector<double> values{10.0, 20.0, 0.0, 40.0, 7.0};
    const double first = -0.5, step = 0.25;  // powers of two: the abscissae are exact
    std::vector<double> abscissae;
    for (std::size_t i = 0; i < values.size(); ++i)
        abscissae.push_back(first + step * static_cast<double>(i));
    for (double x = -1.0; x < 1.0; x += 0.0078125)
        ASSERT_DOUBLE_EQ(interpolate_linear_regular(first, step, values, x),
                         interpolate_linear(abscissae, values, x))
            << x;
}

TEST(InterpolateLinearRegular, EndsGoOnAndNanStays) {
    EXPECT_EQ(interpolate_linear_regular(0.0, 1.0, kValues, -1.0), 10.0);
    EXPECT_EQ(interpolate_linear_regular(0.0, 1.0, kValues, 3.0), 40.0);
    EXPECT_EQ(interpolate_linear_regular(0.0, 1.0, kValues, 1e300), 40.0);
    EXPECT_EQ(interpolate_linear_regular(0.0, 1.0, kValues, -kInfinity), 10.0);
    EXPECT_TRUE(std::isnan(interpolate_linear_regular(0.0, 1.0, kValues, kNan)));
    EXPECT_EQ(interpolate_linear_regular(0.0, 1.0, std::array{7.0}, 0.3), 7.0);
}

TEST(InterpolationDeathTest, TablesMustFit) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(interpolate_linear(kAbscissae, std::array{1.0}, 0.0),
                testing::KilledBySignal(SIGABRT), "one value for each abscissa");
    EXPECT_EXIT(interval_of(std::array{1.0}, 0.0), testing::KilledBySignal(SIGABRT), "two ends");
}

}  // namespace
}  // namespace dewbow
