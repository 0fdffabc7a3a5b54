// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/clear_sky.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/sky/backward_walk.h"
#include "dewbow/sky/sky_light.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;

/// A direction by altitude and azimuth from north clockwise.
Dir<World> towards(double altitude_deg, double azimuth_deg) {
    const double h = altitude_deg * kPi / 180.0;
    const double a = azimuth_deg * kPi / 180.0;
    return {{std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)}};
}

double radiance(const SkyDome& sky, Dir<World> d, double lambda_nm) {
    double out = 0.0;
    sky.radiance_lanes(d, std::span(&lambda_nm, 1), std::span(&out, 1));
    return out;
}

// ---- against photons
// -----------------------------------------------------------------------------

/// A direction by altitude and azimuth from the sun, degrees, and a wavelength.
struct Look {
    double altitude, azimuth, nm;
};

/// What the solver's level air and its 16 degrees of harmonics may cost, as a share, under a sun of
/// at least 5°; measured: 2 % and less.
constexpr double kLevelAir = 0.05;
/// At 4 standard errors a correct sky fails once in 16000 looks, were there no kLevelAir.
constexpr double kErrors = 4.0;

/// How far a dome is from the walk, over what is allowed; the largest of all looks.
double largest_disagreement(const ClearSky& walked, const ClearSky& solved, double sun_deg,
                            std::span<const Look> looks, int photons, double share) {
    const Dir<World> to_sun = towards(sun_deg, 0);
    const ClearSkyDomePtr dome = make_clear_sky_dome(solved, to_sun, make_constant(1.0));
    double worst = 0.0;
    for (const Look& look : looks) {
        const Dir<World> d = towards(look.altitude, look.azimuth);
        const WalkEstimate walk =
            BackwardWalk(walked, look.nm, to_sun.v).radiance(d.v, photons, 20261127);
        const double allowed = share * walk.mean + kErrors * walk.standard_error;
        worst = std::max(worst, std::abs(radiance(*dome, d, look.nm) - walk.mean) / allowed);
    }
    return worst;
}

constexpr Look kFewLooks[] = {{90, 0, 420}, {45, 180, 550}, {10, 30, 650}, {1, 90, 480}};

TEST(ClearSkyDome, IsThatOfPhotonsWalkedBackwards) {
    ClearSky hazy;
    hazy.aerosol_depth_500nm = 0.4;
    hazy.ground_albedo = 0.7;
    EXPECT_LT(largest_disagreement({}, {}, 40.0, kFewLooks, 2500, kLevelAir), 1.0);
    EXPECT_LT(largest_disagreement({}, {}, 6.0, kFewLooks, 2500, kLevelAir), 1.0);
    EXPECT_LT(largest_disagreement(hazy, hazy, 25.0, kFewLooks, 2500, kLevelAir), 1.0);
    // From an aeroplane the horizon lies 1.9° lower, and the ground behind air.
    ClearSky high;
    high.eye_height_m = 4000.0;
    constexpr Look kDown[] = {{-0.5, 120, 550}, {-2.5, 90, 620}, {-20, 60, 450}, {-90, 0, 550}};
    EXPECT_LT(largest_disagreement(high, high, 30.0, kDown, 2500, kLevelAir), 1.0);
}

TEST(ClearSkyDome, OfAnotherSkyIsSeenToDiffer) {
    // Planted: a ground, haze and air that are not those of the walk. One look is enough for each.
    const ClearSky truth;
    ClearSky ground, forward, thin;
    ground.ground_albedo = 0.8;
    forward.aerosol_asymmetry = 0.4;
    thin.pressure_hPa = 800.0;
    constexpr Look kBlueSide[] = {{30, 120, 420}}, kAureole[] = {{35, 15, 650}};
    EXPECT_GT(largest_disagreement(truth, ground, 40.0, kBlueSide, 6000, kLevelAir), 1.0);
    EXPECT_GT(largest_disagreement(truth, forward, 40.0, kAureole, 6000, kLevelAir), 1.0);
    EXPECT_GT(largest_disagreement(truth, thin, 40.0, kBlueSide, 6000, kLevelAir), 1.0);
    // And the true one passes there.
    EXPECT_LT(largest_disagreement(truth, truth, 40.0, kBlueSide, 6000, kLevelAir), 1.0);
    EXPECT_LT(largest_disagreement(truth, truth, 40.0, kAureole, 6000, kLevelAir), 1.0);
}

TEST(ClearSkyDome, KnowsThatFarPlacesHaveAnotherSun) {
    // Opposite a sun at 1° the air a hundred kilometres away is in its last light. Without what
    // puts that right the two sides of the horizon are 17 % wrong against each other (30 % without
    // the slope along lines of sight); with it 4 %. The walk's error is 2 %.
    constexpr double kFirstOrder = 0.05, kWalk = 4.0 * 0.016;
    const Dir<World> to_sun = towards(1, 0);
    const ClearSkyDomePtr dome = make_clear_sky_dome({}, to_sun, make_constant(1.0));
    BackwardWalk walk({}, 550.0, to_sun.v);
    const auto ratio = [](double opposite, double below) { return opposite / below; };
    EXPECT_NEAR(
        ratio(radiance(*dome, towards(1, 180), 550.0), radiance(*dome, towards(1, 0), 550.0)) /
            ratio(walk.radiance(towards(1, 180).v, 25000, 1).mean,
                  walk.radiance(towards(1, 0).v, 25000, 2).mean),
        1.0, kFirstOrder + kWalk);
}

TEST(LongClearSkyDome, IsThatOfPhotonsWalkedBackwardsEverywhere) {
    // 20 000 photons a look are 0.3 to 4 %. Under a sun at 1° the field of far places is known to
    // first order only: up to 6 % opposite it, on the horizon.
    const struct { double sun_deg, share; } rows[] = {{60, 0.03}, {20, 0.03}, {5, 0.05}, {1, 0.08}};
    std::vector<Look> looks;
    for (const double nm_value : {400.0, 550.0, 700.0})
        for (const double altitude : {0.3, 1.0, 10.0, 45.0, 90.0})
            for (const double azimuth : {0.0, 20.0, 90.0, 180.0})
                looks.push_back({altitude, azimuth, nm_value});
    for (const auto& row : rows)
        EXPECT_LT(largest_disagreement({}, {}, row.sun_deg, looks, 20000, row.share), 1.0)
            << row.sun_deg;
}

// ---- what needs no other method
// ------------------------------------------------------------------

TEST(DiffuseField, KeepsAllLightBetweenWhiteGroundAndWhiteHaze) {
    // Nothing is absorbed: as much goes up through every level as comes down, beam and all. The
    // beam of a high sun over a sphere is that of level air within 1e-3.
    ClearSky white{1013.25, 0.5, 1.0, 0.0};
    white.aerosol_albedo = white.ground_albedo = 1.0;
    const SunPlace sun(1.2);
    const SunMasses masses(sun.altitude);
    constexpr double kTwelveNodes = 5e-3;
    for (const double nm_value : {400.0, 700.0}) {
        const AirOptics optics = air_optics(white, nm_value * nm);
        const double onto_ground =
            sun.sine * std::exp(-dot(optics.depth, masses.at(0.0, sun.sine)));
        const DiffuseField field =
            diffuse_field(optics, white.aerosol_asymmetry, white.ground_albedo,
                          beam_moments(optics, sun, masses), onto_ground);
        for (int k = 0; k < kDiffuseLevels; k += 5) {
            const double beam =
                sun.sine * std::exp(-dot(optics.depth, masses.at(diffuse_level_m(k), sun.sine)));
            const double down = 4.0 * kPi * field.moments[k][harmonic_index(kDiffuseDegree, 0, 1)];
            EXPECT_NEAR(beam + down, 0.0, kTwelveNodes * sun.sine) << nm_value << " " << k;
        }
    }
}

TEST(DiffuseField, OfAirAloneIsEddingtons) {
    // Transmission of a layer that scatters all and evenly, over a black ground:
    // (2/3 + μ + (2/3 − μ) e^(−τ/μ)) / (4/3 + τ).      [Eddington's approximation; Meador & Weaver,
    // J. Atmos. Sci. 37, 630 (1980), γ1 = γ2 = 3/4]
    constexpr double kEddington = 0.03;
    ClearSky air{1013.25, 0.0, 1.0, 0.0};
    air.ground_albedo = 0.0;
    for (const double altitude : {0.5, 0.9, 1.4}) {
        const SunPlace sun(altitude);
        const SunMasses masses(sun.altitude);
        const AirOptics optics = air_optics(air, 450.0 * nm);
        const double tau = optics.depth.air, mu = sun.sine, beam = std::exp(-tau / mu);
        const double through =
            mu * ((2.0 / 3.0 + mu + (2.0 / 3.0 - mu) * beam) / (4.0 / 3.0 + tau) - beam);
        const DiffuseField field =
            diffuse_field(optics, 0.7, 0.0, beam_moments(optics, sun, masses), mu * beam);
        EXPECT_NEAR(field.ground_irradiance / through, 1.0, kEddington) << altitude;
    }
}

TEST(ClearSkyDome, IsBlueAboveAndRedAroundALowSun) {
    const ClearSkyDomePtr noon = make_clear_sky_dome({}, towards(60, 180), make_constant(1.0));
    EXPECT_GT(radiance(*noon, towards(45, 0), 450.0), 2.0 * radiance(*noon, towards(45, 0), 650.0));
    const ClearSkyDomePtr evening = make_clear_sky_dome({}, towards(1, 270), make_constant(1.0));
    EXPECT_LT(radiance(*evening, towards(2, 270), 450.0),
              0.1 * radiance(*evening, towards(2, 270), 650.0));
}

TEST(ClearSkyDome, IsSmoothSymmetricAndPositive) {
    // No bands: the luminance's logarithm bends evenly. Between steps of 0.5° its slope changes by
    // less than 2 % a degree (a band of a table linear between its knots: 5 to 20 %), but for the
    // lowest 4°, where air really is in layers, and 10° around the sun.
    for (const double sun_deg : {1.0, 30.0, 85.0}) {
        const ClearSkyDomePtr dome =
            make_clear_sky_dome({}, towards(sun_deg, 90), make_constant(1.0));
        const auto log_at = [&](double altitude, double azimuth) {
            return std::log(dome->luminance(towards(altitude, azimuth)));
        };
        for (double altitude = 0.25; altitude < 90.0; altitude += 7.3)
            for (double azimuth = 0.0; azimuth < 360.0; azimuth += 31.7) {
                const double here = log_at(altitude, azimuth);
                ASSERT_TRUE(std::isfinite(here));
                EXPECT_NEAR(log_at(altitude, 180.0 - azimuth), here, 1e-9);
                const double away =
                    std::acos(std::min(1.0, dot(towards(altitude, azimuth), towards(sun_deg, 90))));
                if (altitude < 4.0 || away < 10.0 * kPi / 180.0) continue;
                const double bend =
                    log_at(altitude + 0.5, azimuth) + log_at(altitude - 0.5, azimuth) - 2.0 * here;
                EXPECT_LT(std::abs(bend), 0.01) << sun_deg << " " << altitude << " " << azimuth;
            }
    }
}

TEST(ClearSkyDome, HasItsLuminanceFromItsRadiance) {
    const ClearSkyDomePtr dome = make_clear_sky_dome({}, towards(25, 200), make_constant(0.01));
    for (const Dir<World> d : {towards(90, 0), towards(3, 190), towards(-40, 10)}) {
        double sum = 0.0;
        for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += 1.0)
            sum += 683.002 * cie_xyz_bar(l)[1] * radiance(*dome, d, l);
        EXPECT_NEAR(dome->luminance(d) / sum, 1.0, 1e-6);
    }
}

TEST(ClearSkyDome, LightsTheGroundThatItShowsBelowTheHorizon) {
    ClearSky sky;
    sky.ground_albedo = 0.3;
    sky.eye_height_m = 0.0;  // no air before it
    const ClearSkyDomePtr dome = make_clear_sky_dome(sky, towards(30, 200), make_constant(1.0));
    const SpectrumPtr beam = make_direct_transmittance(30.0 * deg, sky);
    constexpr double kTwoAirMasses = 3e-3;  // the sky's own, and Kasten & Young's
    for (const double l : {400.0, 550.0, 700.0}) {
        const double down = 0.5 * (*beam)(l * nm) + (*dome->diffuse_irradiance())(l * nm);
        EXPECT_NEAR(radiance(*dome, towards(-1, 0), l) / (0.3 / kPi * down), 1.0, kTwoAirMasses);
        EXPECT_NEAR(radiance(*dome, towards(-1, 0), l) / radiance(*dome, towards(-80, 99), l), 1.0,
                    1e-6);
    }
}

TEST(ClearSkyDome, RefusesWithOneSentence) {
    try {
        make_clear_sky_dome({}, towards(-1, 0), make_constant(1.0));
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.sentence(),
                  "the sun at -1°; a clear sky is known for 0° (the horizon) to 90°");
    }
    ClearSky bright;
    bright.ground_albedo = 1.5;
    EXPECT_THROW(make_clear_sky_dome(bright, towards(10, 0), make_constant(1.0)), InputError);
}

}  // namespace
}  // namespace dewbow
