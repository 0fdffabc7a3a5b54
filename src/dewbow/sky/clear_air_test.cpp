// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/sky/air_optics.h"
#include "dewbow/sky/clear_sky.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Dir<World> towards(double altitude_deg, double azimuth_deg) {
    const double h = altitude_deg * std::numbers::pi / 180.0;
    const double a = azimuth_deg * std::numbers::pi / 180.0;
    return {{std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)}};
}

struct Passed {
    double transmittance = 1.0, airlight = 0.0;
};
Passed pass(const Aerial& air, double height_m, Dir<World> d, double distance_m, double nm_value) {
    Passed out;
    air.eval_lanes(height_m, d, distance_m, std::span(&nm_value, 1),
                   std::span(&out.transmittance, 1), std::span(&out.airlight, 1));
    return out;
}

AerialPtr air_under(double sun_altitude_deg, const ClearSky& sky = {}) {
    return make_clear_sky_dome(sky, towards(sun_altitude_deg, 180), make_constant(1.0))->aerial();
}

TEST(ClearAir, DimsAsItsDensitySays) {
    // Along the ground in air that is the same all the way: e^(−β d).
    const AerialPtr air = air_under(40.0);
    for (const double nm_value : {400.0, 550.0, 700.0}) {
        const double beta = dot(air_optics({}, nm_value * nm).depth, air_density(0.0));
        for (const double d : {10.0, 400.0, 1500.0})
            EXPECT_NEAR(pass(*air, 0.0, towards(0, 30), d, nm_value).transmittance,
                        std::exp(-beta * d), 2e-4)
                << nm_value << " " << d;
    }
    // Straight up and out: the vertical depth.
    constexpr double kTwelveSteps = 3e-3;
    EXPECT_NEAR(pass(*air, 0.0, towards(90, 0), kInfinity, 550.0).transmittance,
                (*make_direct_transmittance(90.0 * deg))(550.0 * nm), kTwelveSteps);
}

TEST(ClearAir, HidesADarkThingAtTheVisibility) {
    ClearSky sky;
    sky.aerosol_depth_500nm = aerosol_depth_from_visibility(20e3 * m);
    // On a sphere the middle of the way to 20 km lies 7 m lower than its ends.
    EXPECT_NEAR(pass(*air_under(40.0, sky), 0.0, towards(0, 30), 20e3, 550.0).transmittance, 0.02,
                5e-4);
}

TEST(ClearAir, OfTwoPiecesIsThatOfTheWhole) {
    const AerialPtr air = air_under(30.0);
    constexpr double kFewSteps = 5e-3;
    for (const double altitude : {-2.0, 0.0, 5.0, 60.0}) {
        const Dir<World> d = towards(altitude, 75);
        const double start = 800.0, first = 3e3, second = 6e3;
        const Passed a = pass(*air, start, d, first, 550.0);
        const Passed b = pass(*air, start + first * d.v.y, d, second, 550.0);
        const Passed whole = pass(*air, start, d, first + second, 550.0);
        EXPECT_NEAR(whole.transmittance, a.transmittance * b.transmittance, kFewSteps) << altitude;
        EXPECT_NEAR((a.airlight + a.transmittance * b.airlight) / whole.airlight, 1.0, kFewSteps)
            << altitude;
    }
}

TEST(ClearAir, OutOfTheAtmosphereIsTheSky) {
    // By other steps, another table, and without the tilt of far places under a low sun.
    const struct { double sun_deg, tolerance; } rows[] = {{60.0, 0.02}, {20.0, 0.03}, {3.0, 0.08}};
    for (const auto& row : rows) {
        const ClearSkyDomePtr dome =
            make_clear_sky_dome({}, towards(row.sun_deg, 180), make_constant(1.0));
        const AerialPtr air = dome->aerial();
        for (const double altitude : {0.3, 2.0, 10.0, 45.0, 90.0})
            for (const double azimuth : {180.0, 200.0, 270.0, 0.0})
                for (double nm_value : {420.0, 550.0, 700.0}) {
                    double sky = 0.0;
                    dome->radiance_lanes(towards(altitude, azimuth), std::span(&nm_value, 1),
                                         std::span(&sky, 1));
                    const Passed out =
                        pass(*air, 0.0, towards(altitude, azimuth), kInfinity, nm_value);
                    EXPECT_NEAR(out.airlight / sky, 1.0, row.tolerance)
                        << row.sun_deg << " " << altitude << " " << azimuth << " " << nm_value;
                }
    }
}

TEST(ClearAir, MultipliesWhatIsThereAndWritesAirlight) {
    const AerialPtr air = air_under(30.0);
    const std::array<double, 2> lambda_nm = {450.0, 650.0};
    std::array<double, 2> left = {0.5, 0.25}, light = {-1.0, -1.0};
    air->eval_lanes(0.0, towards(1, 0), 5e3, lambda_nm, left, light);
    for (int i = 0; i < 2; ++i) {
        const Passed one = pass(*air, 0.0, towards(1, 0), 5e3, lambda_nm[i]);
        EXPECT_DOUBLE_EQ(left[i], (i == 0 ? 0.5 : 0.25) * one.transmittance);
        EXPECT_DOUBLE_EQ(light[i], one.airlight);
    }
    const Passed nothing = pass(*air, 0.0, towards(1, 0), 0.0, 550.0);
    EXPECT_EQ(nothing.transmittance, 1.0);
    EXPECT_EQ(nothing.airlight, 0.0);
    // Blue hills: what air adds is bluer than what it leaves.
    EXPECT_GT(light[0], 1.5 * light[1]);
}

}  // namespace
}  // namespace dewbow
