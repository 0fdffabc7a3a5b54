// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/uneven_rain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewbow {
namespace {

/// Two-sided 1e-7 for one z.
constexpr double kSigmas = 5.33;
/// An error of this share is found with probability 0.99.
constexpr double kDetectable = 0.025;

double density(double s) { return 0.5 + 0.5 * std::sin(3.0 * s); }
/// ∫ density from 1 to 5.
double metres() { return 0.5 * 4.0 - (std::cos(15.0) - std::cos(3.0)) / 6.0; }

/// The z of the mean over exp(−extinction · metres), less 1; `wrong` is added to the density.
double z_of(double extinction, double usual, double wrong = 0.0) {
    const std::array<double, 2> lanes{extinction, 0.5 * extinction};
    double sum = 0.0, squares = 0.0;
    constexpr int kSamples = 40000;
    for (int i = 0; i < kSamples; ++i) {
        const SampleKey key(stream_key(1, std::uint32_t(i), 0), 0);
        RandomSteps steps(key, 0, Purpose::test);
        LaneValues values;
        values[0] = values[1] = 1.0;
        dim_by_uneven_rain(
            {1.0, 5.0}, lanes, usual, [&](double s) { return density(s) + wrong; }, steps, values);
        EXPECT_GE(values[0], 0.0);
        EXPECT_GE(values[1], 0.0);
        const double x = values[0] * std::exp(extinction * metres()) +
                         values[1] * std::exp(0.5 * extinction * metres()) - 2.0;
        sum += x, squares += x * x;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    EXPECT_LT((kSigmas + 2.33) * error, kDetectable * 2.0 * (1.0 + extinction));
    return mean / error;
}

TEST(UnevenRain, MeansAreWhatIsLeft) {
    for (const double usual : {0.5, 0.2, 1.0}) {
        EXPECT_LT(std::abs(z_of(0.3, usual)), kSigmas) << usual;
        EXPECT_LT(std::abs(z_of(1.0, usual)), kSigmas) << usual;
    }
}
TEST(UnevenRain, ALittleMoreRainIsSeen) { EXPECT_LT(z_of(1.0, 0.5, 0.01), -kSigmas); }

TEST(UnevenRain, WithoutEndLeavesNothing) {
    const SampleKey key(1, 0);
    RandomSteps steps(key, 0, Purpose::test);
    LaneValues values;
    values[0] = values[1] = 1.0;
    const std::array<double, 2> extinction{1e-9, 0.0};
    dim_by_uneven_rain(
        {0.0, std::numeric_limits<double>::infinity()}, extinction, 0.5, [](double) { return 0.5; },
        steps, values);
    EXPECT_EQ(values[0], 0.0);
    EXPECT_EQ(values[1], 1.0);
}

}  // namespace
}  // namespace dewbow
