// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/air_optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/math/quadrature.h"
#include "dewbow/sky/diffuse_light.h"

namespace dewbow {
namespace {

TEST(AirOptics, PhaseFunctionsHoldOneAndTheirMoments) {
    // 2π ∫ p P_l dμ = χ_l, by another way than the closed forms that the solver uses.
    constexpr double kQuadrature = 1e-10;
    const QuadratureRule rule = gauss_legendre(96);
    const PhaseMoments air = air_phase_moments(), haze = haze_phase_moments(0.703);
    for (int l = 0; l <= kDiffuseDegree; ++l) {
        const auto moment = [&](const auto& phase) {
            return (2 * l + 1) * 2.0 * std::numbers::pi * integrate(rule, -1.0, 1.0, [&](double x) {
                       return phase(x) * std::legendre(l, x);
                   });
        };
        EXPECT_NEAR(moment(air_phase), air[l], kQuadrature) << l;
        EXPECT_NEAR(moment([](double x) { return haze_phase(x, 0.703); }), haze[l], kQuadrature)
            << l;
    }
    // Sideways over forwards, (1 + ρ) / 2: that is how the depolarisation ρ is measured.
    EXPECT_NEAR(air_phase(0.0) / air_phase(1.0), 0.5 * (1.0 + 0.0279), 1e-12);
}

TEST(AirColumn, HoldsOneOfEachPartAndGrowsToThePublishedAirMass) {
    constexpr double kMidpoints = 2e-3, kUnlikeAtmospheres = 6e-3;
    const AirParts up = air_mass_to_space(0.0, 1.0);
    EXPECT_NEAR(up.air, 1.0, kMidpoints);
    EXPECT_NEAR(up.haze, 1.0, kMidpoints);
    EXPECT_NEAR(up.ozone, 1.0, kMidpoints);
    for (const double h : {0.0, 0.5, 1.0, 2.0, 5.0, 20.0, 60.0})
        EXPECT_NEAR(
            air_mass_to_space(0.0, sin(h * unit::deg)).air / relative_air_mass(h * unit::deg), 1.0,
            kUnlikeAtmospheres)
            << h;
    // What lies above half the pressure: 5.5 km in the standard atmosphere.
    EXPECT_NEAR(air_mass_to_space(5500.0, 1.0).air, 505.4 / 1013.25, 2e-3);
    // Through the ground and out: continuous where the ray grazes it.
    EXPECT_NEAR(air_mass_to_space(2000.0, -0.02341).haze / air_mass_to_space(2000.0, -0.0234).haze,
                1.0, 0.01);
}

TEST(AirColumn, HidesTheSunBehindTheSphere) {
    EXPECT_EQ(visible_share_of_sun(0.0, 0.01), 1.0);
    EXPECT_EQ(visible_share_of_sun(0.0, -0.01), 0.0);
    EXPECT_NEAR(visible_share_of_sun(0.0, 0.0), 0.5, 1e-12);
    // From 2 km the horizon lies √(2 h / R) = 1.34° lower.
    EXPECT_NEAR(visible_share_of_sun(2000.0, sin(-1.339 * unit::deg)), 0.5, 0.01);
}

}  // namespace
}  // namespace dewbow
