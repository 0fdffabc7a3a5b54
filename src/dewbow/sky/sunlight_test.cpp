// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sunlight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

double illuminance(const SpectrumPtr& light) {
    return kLuminousEfficacy * xyz_from_spectrum(*light)[1];
}

TEST(SunlightAbove, IsTheStandards) {
    const SpectrumPtr sun = make_sunlight_above();
    // Rows of ASTM E490-00a, W m⁻² nm⁻¹.
    EXPECT_NEAR((*sun)(359.5 * nm), 0.9911, 1e-4);
    EXPECT_NEAR((*sun)(550.5 * nm), 1.862, 1e-4);
    EXPECT_NEAR((*sun)(556.5 * nm), 1.821, 1e-3);
    // The solar illumination constant: 133.1 klx of E490 by R. Darula, S. Kittler & C. Gueymard,
    // Sol. Energy 79, 559 (2005), who give 133 334 lx.
    EXPECT_NEAR(illuminance(sun), 133'334.0, 100.0);
    EXPECT_NEAR(illuminance(make_sunlight_above(1.0167)), 133'334.0 / (1.0167 * 1.0167), 100.0);
}

TEST(MoonlightAbove, HasTheMagnitudesOfTheMoon) {
    // Another source, from photometry by eye and photocell: V = −12.73 + 0.026 g + 4e-9 g⁴, without
    // the surge near full moon.   [Krisciunas & Schaefer, Publ. Astron. Soc. Pacific 103, 1033
    // (1991), eq. 9]. Magnitude 0 is 2.54e-6 lx [Allen's Astrophysical Quantities 2000].
    constexpr double kPhotometry = 0.08;
    for (const double g : {7.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 97.0}) {
        const double magnitude = -12.73 + 0.026 * g + 4e-9 * std::pow(g, 4);
        const double expected = 2.54e-6 * std::pow(10.0, -0.4 * magnitude);
        EXPECT_NEAR(illuminance(make_moonlight_above(g * deg)) / expected, 1.0, kPhotometry) << g;
    }
    // The surge: up to 35 % where the moon is fullest [the same, p. 1035], a part of it at 1.55°.
    const double full = 2.54e-6 * std::pow(10.0, 0.4 * 12.73);
    EXPECT_GT(illuminance(make_moonlight_above(Angle{})) / full, 1.1);
    EXPECT_LT(illuminance(make_moonlight_above(Angle{})) / full, 1.35);
    EXPECT_EQ((*make_moonlight_above(Angle{}))(500.0 * nm),
              (*make_moonlight_above(1.0 * deg))(500.0 * nm));
}

TEST(MoonlightAbove, IsRedderThanTheSun) {
    // B − V of 0.92 against 0.65 [Allen's Astrophysical Quantities 2000]: bands at 440 and 550 nm.
    const SpectrumPtr moon = make_moonlight_above(30.0 * deg), sun = make_sunlight_above();
    const auto reflectance = [&](double l) { return (*moon)(l * nm) / (*sun)(l * nm); };
    EXPECT_NEAR(reflectance(440.0) / reflectance(550.0), std::pow(10.0, -0.4 * 0.27), 0.04);
}

TEST(MoonlightAbove, RefusesACrescent) {
    for (const double g : {-1.0, 98.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(make_moonlight_above(g * deg), InputError) << g;
}

}  // namespace
}  // namespace dewbow
