// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/clear_sky.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

/// A direction by altitude and azimuth from north clockwise.
Dir<World> towards(double altitude_deg, double azimuth_deg) {
    const double h = altitude_deg * std::numbers::pi / 180.0;
    const double a = azimuth_deg * std::numbers::pi / 180.0;
    return {{std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)}};
}

double radiance(const SkyDome& sky, Dir<World> d, double lambda_nm) {
    double out = 0.0;
    sky.radiance_lanes(d, std::span(&lambda_nm, 1), std::span(&out, 1));
    return out;
}

TEST(ClearSkyDome, IsBlueAboveAndRedAroundALowSun) {
    const ClearSkyDomePtr noon = make_clear_sky_dome({}, towards(60, 180), make_constant(1.0));
    EXPECT_GT(radiance(*noon, towards(45, 0), 450.0), 2.0 * radiance(*noon, towards(45, 0), 650.0));
    const ClearSkyDomePtr evening = make_clear_sky_dome({}, towards(1, 270), make_constant(1.0));
    EXPECT_LT(radiance(*evening, towards(2, 270), 450.0),
              0.3 * radiance(*evening, towards(2, 270), 650.0));
}

TEST(ClearSkyDome, RefusesASunBelowTheHorizon) {
    EXPECT_THROW(make_clear_sky_dome({}, towards(-1, 0), make_constant(1.0)), InputError);
}

}  // namespace
}  // namespace dewbow
