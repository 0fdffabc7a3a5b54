// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/overcast.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "dewbow/base/error.h"
#include "dewbow/sky/cloud_bank.h"
#include "dewbow/sky/sun_position.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

double luminance_by_lanes(const SkyDome& sky, Dir<World> direction) {
    double sum = 0.0;
    for (double l = 360.5; l < 830.0; l += 1.0) {
        double radiance = 0.0;
        sky.radiance_lanes(direction, {&l, 1}, {&radiance, 1});
        sum += radiance * cie_xyz_bar(l)[1];
    }
    return kLuminousEfficacy * sum;
}

TEST(OvercastDome, IsThreeTimesAsBrightOverheadAsAtTheHorizon) {
    const SkyDomePtr sky = make_overcast_dome(30.0 * deg);
    // Zenith luminance of the same authors, another fit: 123 + 8600 sin h.
    EXPECT_NEAR(sky->luminance({{0, 1, 0}}), 123.0 + 8600.0 * 0.5, 10.0);
    EXPECT_NEAR(sky->luminance({{1, 0, 0}}) * 3.0, sky->luminance({{0, 1, 0}}), 1e-9);
    EXPECT_NEAR(illuminance_lx(*sky), 10'800.0, 5.0);
    EXPECT_NEAR(sky->luminance({{0, -1, 0}}), 0.2 * 10'800.0 / 3.14159265, 1e-3);
    const Dir<World> aside = direction_to(20.0 * deg, 77.0 * deg);
    EXPECT_NEAR(luminance_by_lanes(*sky, aside) / sky->luminance(aside), 1.0, 1e-3);
}

TEST(OvercastDome, RefusesWithOneSentence) {
    EXPECT_THROW(make_overcast_dome(-1.0 * deg), InputError);
    EXPECT_THROW(make_overcast_dome(std::numeric_limits<double>::quiet_NaN() * deg), InputError);
    EXPECT_THROW(make_overcast_dome(30.0 * deg, 1.5), InputError);
}

TEST(CloudBank, HidesWhatIsBehindIt) {
    const SkyDomePtr sky = make_overcast_dome(30.0 * deg);
    CloudBank bank;
    bank.azimuth = 90.0 * deg, bank.width = 120.0 * deg, bank.top = 40.0 * deg;
    bank.softness = 4.0 * deg, bank.luminance_share = 0.25, bank.texture = 0.0;
    const SkyDomePtr darker = make_cloud_bank_dome(sky, bank, make_constant(1.0));
    const double dark = 0.25 * illuminance_lx(*sky) / 3.14159265;
    const auto at = [&](double altitude, double azimuth) {
        return direction_to(altitude * deg, azimuth * deg);
    };
    EXPECT_NEAR(darker->luminance(at(20, 90)), dark, 0.01);
    EXPECT_NEAR(darker->luminance(at(37, 40)), dark, 0.01);
    EXPECT_NEAR(luminance_by_lanes(*darker, at(20, 90)) / dark, 1.0, 1e-3);
    for (const Dir<World> clear : {at(43, 90), at(20, 0), at(20, 152), at(20, -90), at(-20, 90)})
        EXPECT_EQ(darker->luminance(clear), sky->luminance(clear));
    // Halfway through an edge.
    EXPECT_NEAR(darker->luminance(at(40, 90)), 0.5 * (dark + sky->luminance(at(40, 90))), 0.01);
    EXPECT_NEAR(cover_towards(bank, at(20, 150)), 0.5, 1e-9);
    // All around, up to the zenith and not beyond; half transparent.
    bank = {};
    bank.width = 360.0 * deg, bank.bottom = 10.0 * deg, bank.softness = Angle{}, bank.cover = 0.5;
    EXPECT_EQ(cover_towards(bank, at(90, 0)), 0.5);
    EXPECT_EQ(cover_towards(bank, at(9, 123)), 0.0);
}

TEST(CloudBank, IsUnevenAboutItsMean) {
    const SkyDomePtr sky = make_overcast_dome(30.0 * deg);
    CloudBank bank;
    bank.width = 360.0 * deg, bank.texture = 0.6, bank.luminance_share = 0.25;
    const SkyDomePtr cloudy = make_cloud_bank_dome(sky, bank, make_constant(1.0));
    // Overcast all around: cells of 15° leave a mean that is uncertain by a few per cent.
    EXPECT_NEAR(illuminance_lx(*cloudy) / illuminance_lx(*sky), 0.25, 0.04);
    bank.seed = 1;
    const SkyDomePtr other = make_cloud_bank_dome(sky, bank, make_constant(1.0));
    const Dir<World> somewhere = direction_to(40.0 * deg, 20.0 * deg);
    EXPECT_NE(cloudy->luminance(somewhere), other->luminance(somewhere));
    EXPECT_NEAR(luminance_by_lanes(*other, somewhere) / other->luminance(somewhere), 1.0, 1e-3);
}

TEST(CloudBank, RefusesWithOneSentence) {
    CloudBank bank;
    bank.bottom = 20.0 * deg, bank.top = 10.0 * deg;
    try {
        validate(bank);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.sentence(),
                  "the upper edge of a bank of cloud must be above its lower edge");
    }
    bank = {};
    bank.luminance_share = -1.0;
    EXPECT_THROW(validate(bank), InputError);
}

TEST(SumOfDomes, Adds) {
    const SkyDomePtr a = make_overcast_dome(30.0 * deg), b = make_overcast_dome(10.0 * deg);
    const SkyDomePtr both = make_sum_of_domes(a, b);
    const Dir<World> up = direction_to(50.0 * deg, 10.0 * deg);
    EXPECT_DOUBLE_EQ(both->luminance(up), a->luminance(up) + b->luminance(up));
    EXPECT_NEAR(luminance_by_lanes(*both, up) / both->luminance(up), 1.0, 1e-3);
}

}  // namespace
}  // namespace dewbow
