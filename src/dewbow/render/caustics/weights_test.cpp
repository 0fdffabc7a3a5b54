// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/weights.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewbow::caustics {
namespace {

/// Three divisions and three sums.
constexpr double kRounding = 1e-15;
constexpr double kRatios[]{0.0, 1e-200, 1e-6, 0.3, 1.0, 7.0, 1e6, 1e100};
constexpr double kDensities[]{1e-6, 0.4, 1.0, 25.0, 1e9};

/// By chance, next event and light paths, where the surface next to the lamp is rough glass.
TEST(CausticsWeights, ThreeTechniquesSumToOne) {
    for (const double chance : kDensities)
        for (const double direct : kDensities)
            for (const double ratio : kRatios)
                EXPECT_NEAR(power_heuristic(chance, direct, chance * ratio) +
                                power_heuristic(direct, chance, chance * ratio) +
                                weight_of_light(ratio, 1.0 + direct * direct / (chance * chance)),
                            1.0, kRounding)
                    << chance << ", " << direct << ", " << ratio;
}

/// By chance and light paths, where it is smooth.
TEST(CausticsWeights, TwoTechniquesSumToOne) {
    for (const double ratio : kRatios)
        EXPECT_NEAR(power_heuristic(1.0, 0.0, ratio) + weight_of_light(ratio, 1.0), 1.0, kRounding)
            << ratio;
}

/// Next event and light paths, of a lamp without extent.
TEST(CausticsWeights, LampsWithoutExtentSumToOne) {
    for (const double chance : kDensities)
        for (const double direct : kDensities)
            for (const double ratio : kRatios)
                EXPECT_NEAR(power_heuristic(direct, 0.0, chance * ratio) +
                                weight_of_light(ratio, direct * direct / (chance * chance)),
                            1.0, kRounding)
                    << chance << ", " << direct << ", " << ratio;
}

/// A path that camera paths never take is the light paths' alone, and the other way round.
TEST(CausticsWeights, EndsAreZeroAndOne) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(weight_of_light(infinite, 1.0), 1.0);
    EXPECT_EQ(power_heuristic(1.0, 0.0, infinite), 0.0);
    EXPECT_EQ(weight_of_light(0.0, 1.0), 0.0);
    EXPECT_EQ(power_heuristic(1.0, 0.0, 0.0), 1.0);
    EXPECT_EQ(weight_of_light(1.0, 0.0), 1.0) << "no extent, behind smooth glass";
}

/// A point is the limit of a small lamp: its weights are those of a ball of radius r and the same
/// intensity, whose rays and directions have densities by area and solid angle.
TEST(CausticsWeights, APointIsASmallBall) {
    constexpr double kRadius = 1e-3, kDistance = 2.0, kArea = 3.141592653589793 * kRadius * kRadius;
    constexpr double kChoice = 0.3, kPerSr = 5.0, kNote = 1e-4, kChance = 0.7;
    const double solid_angle = kArea / (kDistance * kDistance);
    const double of_ball =
        power_heuristic(kChoice / solid_angle, 0.0, kChance * kNote * kPerSr / kArea);
    const double of_point =
        power_heuristic(choice_by_extent(LightSample::Source::punctual, kChoice, kDistance), 0.0,
                        kChance * kNote * kPerSr);
    EXPECT_NEAR(of_ball, of_point, kRounding);
}

}  // namespace
}  // namespace dewbow::caustics
