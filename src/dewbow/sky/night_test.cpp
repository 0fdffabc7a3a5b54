// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/night.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dewbow/sky/cloud_bank.h"
#include "dewbow/sky/sun_position.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

TEST(MoonlessDome, IsAsDarkAsTheDarkestPlaces) {
    const SkyDomePtr night = make_moonless_dome();
    // 21.9 magnitudes a square second overhead, 21.6 to 22.0 by site and year of the solar cycle.
    // [Patat, Astron. Astrophys. 400, 1183 (2003); Garstang 1989]
    const double magnitude = 2.5 * std::log10(1.08e5 / night->luminance({{0, 1, 0}}));
    EXPECT_GT(magnitude, 21.6);
    EXPECT_LT(magnitude, 22.0);
    // Starlight on level ground: of the order of a millilux.
    EXPECT_NEAR(illuminance_lx(*night), 8e-4, 3e-4);
    // Brighter by up to one magnitude towards the horizon, and then the air's.
    const double low = night->luminance(direction_to(15.0 * deg, 50.0 * deg));
    EXPECT_GT(low, 1.2 * night->luminance({{0, 1, 0}}));
    EXPECT_LT(low, 2.5 * night->luminance({{0, 1, 0}}));
    EXPECT_NEAR(night->luminance({{0, -1, 0}}), 0.2 / 3.14159265 * illuminance_lx(*night), 2e-6);
}

TEST(MoonlessDome, HasTheGreenLineAndTheLuminanceOfItsSpectrum) {
    const SkyDomePtr night = make_moonless_dome();
    const Dir<World> aside = direction_to(35.0 * deg, 10.0 * deg);
    double sum = 0.0;
    for (double l = 360.25; l < 830.0; l += 0.5) {
        double radiance = 0.0;
        night->radiance_lanes(aside, {&l, 1}, {&radiance, 1});
        sum += 0.5 * radiance * cie_xyz_bar(l)[1];
    }
    EXPECT_NEAR(kLuminousEfficacy * sum / night->luminance(aside), 1.0, 0.01);
    const std::array<double, 2> lambda_nm = {557.7, 545.0};
    std::array<double, 2> radiance{};
    night->radiance_lanes({{0, 1, 0}}, lambda_nm, radiance);
    EXPECT_GT(radiance[0], 2.0 * radiance[1]);
}

}  // namespace
}  // namespace dewbow
