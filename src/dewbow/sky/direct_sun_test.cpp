// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/direct_sun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow {
namespace {

using namespace unit;

TEST(AirMass, IsThatOfTheFormulaAndOfAShell) {
    // Published values of the formula, three digits; secants for a high sun.
    EXPECT_NEAR(relative_air_mass({}), 37.92, 0.005);
    EXPECT_NEAR(relative_air_mass(1.0 * deg), 26.3, 0.05);
    EXPECT_NEAR(relative_air_mass(30.0 * deg), 1.99, 0.005);
    EXPECT_NEAR(relative_air_mass(60.0 * deg), 1.0 / std::sin(std::acos(-1.0) / 3.0), 1e-3);
    EXPECT_NEAR(relative_air_mass(90.0 * deg), 1.0, 1e-3);
    EXPECT_NEAR(relative_ozone_mass(90.0 * deg), 1.0, 1e-5);
    // A straight line through a thin shell at 22 km above a sphere of 6370 km.
    for (const double h : {0.0, 2.0, 10.0, 45.0}) {
        const double along = std::cos(h * std::acos(-1.0) / 180.0) * 6370.0 / 6392.0;
        EXPECT_NEAR(relative_ozone_mass(h * deg), 1.0 / std::sqrt(1.0 - along * along), 0.02) << h;
    }
}

TEST(AirMass, OfHazeIsThatOfAnExponentialShell) {
    // A straight line that grazes a sphere of radius R, density exp(−h / H): √(π R / 2 H) (1 + 3 H
    // / 8 R).                                    [Chapman 1931, first terms of the grazing case]
    constexpr double kSphere_m = 6371e3 / 0.87, kScale_m = 1500.0;
    EXPECT_NEAR(relative_haze_mass({}), std::sqrt(std::acos(-1.0) * kSphere_m / (2.0 * kScale_m)),
                0.05);
    EXPECT_NEAR(relative_haze_mass(30.0 * deg), 2.0, 0.005);
    EXPECT_NEAR(relative_haze_mass(90.0 * deg), 1.0, 2e-3);
}

TEST(RayleighDepth, AgreesWithBodhaine) {
    // B. Bodhaine et al., J. Atmos. Ocean. Tech. 16, 1854 (1999), eq. 30: another evaluation of
    // index and depolarisation.
    constexpr double kOtherIndexOfAir = 0.006;
    for (double nm = 360.0; nm <= 830.0; nm += 10.0) {
        const double x = 1e-6 * nm * nm;
        const double bodhaine = 0.0021520 * (1.0455996 - 341.29061 / x - 0.90230850 * x) /
                                (1.0 + 0.0027059889 / x - 85.968563 * x);
        EXPECT_NEAR(rayleigh_depth(nm * unit::nm) / bodhaine, 1.0, kOtherIndexOfAir) << nm;
    }
}

TEST(OzoneDepth, HasTheChappuisBands) {
    // About 0.04 at 602 nm for 300 Dobson units, a tenth of it at 470 and at 730 nm.
    EXPECT_NEAR(ozone_depth(602.0 * nm, 300.0), 0.039, 0.002);
    EXPECT_LT(ozone_depth(470.0 * nm, 300.0), 0.1 * ozone_depth(602.0 * nm, 300.0));
    EXPECT_LT(ozone_depth(740.0 * nm, 300.0), 0.2 * ozone_depth(602.0 * nm, 300.0));
    EXPECT_EQ(ozone_depth(602.0 * nm, 0.0), 0.0);
    EXPECT_NEAR(ozone_depth(602.0 * nm, 600.0), 2.0 * ozone_depth(602.0 * nm, 300.0), 1e-15);
}

/// T at 450, 500, 550, 600, 650 and 700 nm with β = 0.1, α = 1.3, and 300 Dobson units as a
/// Gaussian of 0.039 exp(−((λ − 602)/55)²), all along the air's path: an own computation, five
/// decimals. Haze by its own path takes more from a low sun, by what is put back here.
TEST(DirectTransmittance, IsTheReferenceWithItsOzoneTakenOff) {
    const struct {
        double altitude_deg, t[6];
    } rows[] = {{1, {0.00014, 0.00159, 0.00497, 0.00747, 0.02606, 0.06701}},
                {2, {0.00146, 0.00858, 0.01990, 0.02687, 0.06760, 0.13582}},
                {5, {0.03135, 0.08020, 0.12526, 0.14690, 0.23962, 0.34689}},
                {10, {0.15307, 0.25470, 0.32433, 0.35360, 0.46098, 0.56334}},
                {20, {0.37703, 0.49125, 0.55699, 0.58258, 0.66867, 0.74212}},
                {42, {0.60565, 0.69391, 0.74019, 0.75748, 0.81310, 0.85785}},
                {90, {0.71470, 0.78289, 0.81749, 0.83023, 0.87058, 0.90240}}};
    ClearSky sky;
    sky.ozone_dobson = 0.0;
    for (const auto& row : rows) {
        const SpectrumPtr t = make_direct_transmittance(row.altitude_deg * deg, sky);
        const double mass = relative_air_mass(row.altitude_deg * deg);
        const double longer = relative_haze_mass(row.altitude_deg * deg) - mass;
        for (int k = 0; k < 6; ++k) {
            const double nm_value = 450.0 + 50.0 * k;
            const double ozone = 0.039 * std::exp(-std::pow((nm_value - 602.0) / 55.0, 2));
            const double haze = 0.1 * std::pow(nm_value / 500.0, -1.3);
            EXPECT_NEAR((*t)(nm_value * nm) * std::exp(longer * haze - mass * ozone), row.t[k],
                        6e-6 + 1e-3 * row.t[k])
                << row.altitude_deg << " " << nm_value;
        }
    }
}

TEST(DirectTransmittance, IsThatOfAstmG173BetweenItsWaterBands) {
    // Direct and circumsolar light over light above the atmosphere, means over 7 nm, at air
    // mass 1.5 with 343.8 Dobson units and haze of 0.084 at 500 nm.           [ASTM G173-03;
    // SMARTS 2.9.2]
    constexpr double kRuralHaze = 0.01;  // its exponent changes with wavelength, 1.2 in the mean
    const struct {
        double nm, t;
    } g173[] = {{400, .4990}, {450, .6221}, {500, .6980}, {530, .7191}, {550, .7322},
                {670, .8372}, {680, .8466}, {750, .8848}, {778, .8951}};
    ClearSky sky;
    sky.aerosol_depth_500nm = 0.084;
    sky.angstrom_exponent = 1.2;
    sky.ozone_dobson = 343.8;
    const SpectrumPtr t = make_direct_transmittance(41.81 * deg, sky);
    for (const auto& row : g173) EXPECT_NEAR((*t)(row.nm * nm) / row.t, 1.0, kRuralHaze) << row.nm;
}

TEST(DirectTransmittance, ReddensALowSun) {
    // Red over blue: 3 at 10°, tens at 2°.
    const auto ratio = [](double altitude) {
        const SpectrumPtr t = make_direct_transmittance(altitude * deg);
        return (*t)(650.0 * nm) / (*t)(450.0 * nm);
    };
    EXPECT_NEAR(ratio(10.0), 3.0, 0.3);
    EXPECT_GT(ratio(2.0), 40.0);
    EXPECT_GT(ratio(0.0), 1000.0);
    EXPECT_LT(ratio(90.0), 1.3);
    // Nothing but ozone, which light of a low sun crosses less obliquely than the air below.
    const ClearSky ozone{1013.25, 0.0, 0.0, 300.0};
    ClearSky none = ozone;
    none.ozone_dobson = 0.0;
    EXPECT_NEAR((*make_direct_transmittance({}, ozone))(602.0 * nm) /
                    (*make_direct_transmittance({}, none))(602.0 * nm),
                std::exp(-12.1 * 0.0398), 2e-3);
    // Nothing but air, from a mountain of half the pressure.
    const ClearSky thin{506.625, 0.0, 0.0, 0.0};
    EXPECT_NEAR((*make_direct_transmittance(90.0 * deg, thin))(500.0 * nm),
                std::exp(-0.5 * rayleigh_depth(500.0 * nm) * relative_air_mass(90.0 * deg)), 1e-14);
}

std::string refusal(Angle altitude, const ClearSky& sky) {
    try {
        make_direct_transmittance(altitude, sky);
    } catch (const InputError& error) {
        return error.sentence();
    }
    return "accepted";
}

TEST(DirectTransmittance, RefusesWithOneSentence) {
    EXPECT_EQ(refusal(-1.0 * deg, {}), "the sun at -1°; expected 0° (the horizon) to 90°");
    EXPECT_EQ(refusal(91.0 * deg, {}), "the sun at 91°; expected 0° (the horizon) to 90°");
    EXPECT_EQ(refusal(std::numeric_limits<double>::quiet_NaN() * deg, {}),
              "the sun at nan°; expected 0° (the horizon) to 90°");
    EXPECT_EQ(refusal({}, {1013.25, -0.1, 1.3, 300.0}),
              "aerosol depth -0.1 of a clear sky; expected 0 to 5");
    EXPECT_EQ(refusal({}, {1013.25, 0.1, 9.0, 300.0}),
              "Ångström exponent 9 of a clear sky; expected -1 to 4");
    EXPECT_EQ(refusal({}, {1013.25, 0.1, 1.3, 3000.0}),
              "ozone column 3000 of a clear sky; expected 0 to 700");
    ClearSky steep;
    steep.aerosol_asymmetry = 0.95;
    EXPECT_EQ(refusal({}, steep),
              "asymmetry of the aerosol 0.95 of a clear sky; expected 0 to 0.8");
    EXPECT_EQ(refusal({}, {0.0, 0.1, 1.3, 300.0}),
              "pressure 0 of a clear sky; expected 100 to 1100");
}

TEST(Visibility, IsThatOf6SAndComesBack) {
    // 23 km is haze of depth 0.235 at 550 nm.  [Vermote et al., 6S User Guide, 1997: standard
    // visibility of the continental model]
    constexpr double kOneScaleHeight = 0.05;  // 6S has its own profile of haze
    ClearSky sky;
    sky.angstrom_exponent = 0.0;
    EXPECT_NEAR(aerosol_depth_from_visibility(23e3 * m, sky) / 0.235, 1.0, kOneScaleHeight);
    sky.angstrom_exponent = 1.3;
    for (const double km : {5.0, 20.0, 60.0, 200.0}) {
        sky.aerosol_depth_500nm = aerosol_depth_from_visibility(km * 1e3 * m, sky);
        EXPECT_NEAR(visibility_of(sky).to(m) / (km * 1e3), 1.0, 1e-12);
    }
    EXPECT_THROW(aerosol_depth_from_visibility(500e3 * m), InputError);
    EXPECT_THROW(aerosol_depth_from_visibility(0.1e3 * m), InputError);
}

TEST(DirectSunlight, IsTheProductAndTurnsFromWhiteToRed) {
    const SpectrumPtr sun = find_illuminant("sun-am0");
    ASSERT_NE(sun, nullptr);
    const SpectrumPtr low = make_direct_sunlight(sun, 5.0 * deg);
    const SpectrumPtr t = make_direct_transmittance(5.0 * deg);
    double most = 0.0;
    for (double l = 360.0; l <= 830.0; l += 0.5) {
        ASSERT_DOUBLE_EQ((*low)(l * nm), (*sun)(l * nm) * (*t)(l * nm));
        most = std::max(most, (*low)(l * nm));
    }
    EXPECT_NEAR(low->max_value() / most, 1.0, 0.03);
    const auto x_of = [](const SpectrumPtr& light) {
        const auto xyz = xyz_from_spectrum(*light);
        return xyz[0] / (xyz[0] + xyz[1] + xyz[2]);
    };
    EXPECT_LT(x_of(sun), x_of(make_direct_sunlight(sun, 40.0 * deg)));
    EXPECT_LT(x_of(make_direct_sunlight(sun, 40.0 * deg)), x_of(low));
    EXPECT_LT(x_of(low), x_of(make_direct_sunlight(sun, 1.0 * deg)));
}

}  // namespace
}  // namespace dewbow
