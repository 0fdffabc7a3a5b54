// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/sky.h"

#include <gtest/gtest.h>

#include "dewbow/import/toml/scene_toml.h"
#include "dewbow/sky/cloud_bank.h"
#include "dewbow/sky/direct_sun.h"
#include "dewbow/sky/sunlight.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

Scene scene_of(const std::string& text) { return parse_scene_toml("scene.toml", text).scene; }

double illuminance(const SpectrumPtr& light) {
    return kLuminousEfficacy * xyz_from_spectrum(*light)[1];
}

const SkyDome& dome_of(const Scene& scene) { return *std::get<SkyDomePtr>(scene.lights[0]); }
const DistantLight& disc_of(const Scene& scene) { return std::get<DistantLight>(scene.lights[1]); }

TEST(SkyToml, AClearSkyIsADomeAndASun) {
    const Scene scene = scene_of(
        "[sky]\nsun = { altitude_deg = 30, azimuth_deg = 90 }\naerosol_depth = 0.2\n"
        "angstrom_exponent = 1\nozone_dobson = 350\n");
    ASSERT_EQ(scene.lights.size(), 2u);
    const DistantLight& sun = disc_of(scene);
    EXPECT_NEAR(sun.direction.v.x, -std::sqrt(0.75), 1e-12);  // it travels to the west, and down
    EXPECT_NEAR(sun.direction.v.y, -0.5, 1e-12);
    EXPECT_EQ(sun.angular_radius, kSunRadius);
    ClearSky air;
    air.aerosol_depth_500nm = 0.2, air.angstrom_exponent = 1.0, air.ozone_dobson = 350.0;
    EXPECT_DOUBLE_EQ((*sun.irradiance)(550.0 * nm),
                     (*make_direct_sunlight(make_sunlight_above(), 30.0 * deg, air))(550.0 * nm));
    // Clear days: a tenth to a third of daylight is the sky's.
    const double sky = illuminance_lx(dome_of(scene));
    EXPECT_GT(sky, 7'000.0);
    EXPECT_LT(sky, 20'000.0);
    EXPECT_EQ(scene.film.exposure, ExposureMode::automatic);
}

TEST(SkyToml, ASkyIsSeenFromAHeight) {
    const std::string sun = "[sky]\nsun = { altitude_deg = 30, azimuth_deg = 90 }\n";
    const Dir<World> down{normalised({0.0, -0.0175, 1.0})};
    // At 4 km the horizon lies 1.9° below the level, and 1° below is sky.
    const double ground = dome_of(scene_of(sun)).luminance(down);
    const double haze = dome_of(scene_of(sun + "eye_height_m = 4000\n")).luminance(down);
    EXPECT_GT(haze, 1.5 * ground);
}

// At 4 km the horizon lies 1.9° below the level; a bank that goes down to it has no gap there.
TEST(SkyToml, ABankOfCloudGoesDownToTheHorizonOfAHighEye) {
    const std::string sky =
        "[sky]\nsun = { altitude_deg = 30, azimuth_deg = 180 }\neye_height_m = 4000\n";
    const std::string bank =
        "cloud = { azimuth_deg = 0, bottom_deg = -90, softness_deg = 0, luminance_share = 0.1, "
        "texture = 0 }\n";
    const Scene scene = scene_of(sky + bank);
    const auto north = [&](double altitude_deg) {
        const Angle a = altitude_deg * deg;
        return dome_of(scene).luminance(Dir<World>{{0.0, sin(a), -cos(a)}});
    };
    EXPECT_NEAR(north(-1.0), north(5.0), 1e-9 * north(5.0));
    EXPECT_GT(north(-3.0), 1.5 * north(5.0));  // ground in the sun
}

// Cloud has the colour of the light that falls on it: a low sun's is red.
TEST(SkyToml, CloudIsRedderAtSunset) {
    const auto red_over_blue = [](const char* altitude) {
        const Scene scene = scene_of(
            std::string("[sky]\nsun = { altitude_deg = ") + altitude +
            ", azimuth_deg = 180 }\ncloud = { azimuth_deg = 0, softness_deg = 0, texture = 0 }\n");
        const std::array<double, 2> lambda_nm{650.0, 450.0};
        std::array<double, 2> radiance;
        dome_of(scene).radiance_lanes(Dir<World>{normalised({0.0, 0.3, -1.0})}, lambda_nm,
                                      radiance);
        return radiance[0] / radiance[1];
    };
    EXPECT_GT(red_over_blue("1.5"), 1.05 * red_over_blue("30"));
}

TEST(SkyToml, TheSunStandsByDateTimeAndPlace) {
    // The published example of sun_position_test.cpp, in thicker air.
    const Scene scene = scene_of(
        "[sky]\nsun = { date = \"2003-10-17\", time = \"12:30:30\", utc_offset_h = -7, "
        "latitude_deg = 39.742476, longitude_deg = -105.1786 }\n");
    const Vec3 to_sun = -disc_of(scene).direction.v;
    EXPECT_NEAR(std::asin(to_sun.y) * 57.2957795, 39.892, 0.01);
    EXPECT_NEAR(std::atan2(to_sun.x, -to_sun.z) * 57.2957795 + 360.0, 194.340, 0.01);
    // Nearer than the mean distance by 0.35 %.
    const SpectrumPtr mean = make_direct_sunlight(make_sunlight_above(), 39.892 * deg);
    EXPECT_NEAR((*disc_of(scene).irradiance)(550.0 * nm) / (*mean)(550.0 * nm), 1.00695, 2e-4);
}

TEST(SkyToml, ANightHasAMoonOrNot) {
    const Scene dark = scene_of("[sky]\nkind = \"night\"\n");
    ASSERT_EQ(dark.lights.size(), 1u);
    EXPECT_LT(illuminance_lx(dome_of(dark)), 2e-3);
    const Scene lit =
        scene_of("[sky]\nmoon = { altitude_deg = 40, azimuth_deg = 120, phase_deg = 10 }\n");
    ASSERT_EQ(lit.lights.size(), 2u);
    EXPECT_EQ(disc_of(lit).angular_radius, kMoonRadius);
    // A fifth to a quarter of a lux at the ground.
    EXPECT_NEAR(illuminance(disc_of(lit).irradiance), 0.2, 0.05);
    EXPECT_GT(illuminance_lx(dome_of(lit)), 10.0 * illuminance_lx(dome_of(dark)));
}

TEST(SkyToml, CloudHidesSkyAndSun) {
    const std::string sun = "[sky]\nsun = { altitude_deg = 30, azimuth_deg = 250 }\n";
    const Scene clear = scene_of(sun);
    const Scene behind_viewer =
        scene_of(sun + "cloud = { azimuth_deg = 70, luminance_share = 0.2 }\n");
    ASSERT_EQ(behind_viewer.lights.size(), 2u);
    EXPECT_EQ(illuminance(disc_of(behind_viewer).irradiance),
              illuminance(disc_of(clear).irradiance));
    // The half of the sky that lies away from the sun brings a fifth of its light.
    EXPECT_LT(illuminance_lx(dome_of(behind_viewer)), 0.85 * illuminance_lx(dome_of(clear)));
    const Scene hidden = scene_of(sun + "cloud = { azimuth_deg = 250 }\n");
    EXPECT_EQ(hidden.lights.size(), 1u);
    const Scene veiled = scene_of(sun + "cloud = { width_deg = 360, cover = 0.75 }\n");
    EXPECT_NEAR(illuminance(disc_of(veiled).irradiance) / illuminance(disc_of(clear).irradiance),
                0.25, 1e-9);
}

TEST(SkyToml, AnOvercastSkyHasNoSun) {
    const Scene scene = scene_of(
        "[sky]\nkind = \"overcast\"\nsun = { altitude_deg = 30, azimuth_deg = 0 }\n"
        "ground_albedo = 0.8\n");
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_NEAR(illuminance_lx(dome_of(scene)), 10'800.0, 10.0);
    EXPECT_NEAR(dome_of(scene).luminance({{0, -1, 0}}), 0.8 * 10'800.0 / 3.14159265, 1.0);
}

TEST(SkyToml, WhoStatesExposureOrWhiteIsObeyed) {
    const std::string sky = "[sky]\nkind = \"night\"\n";
    EXPECT_EQ(scene_of(sky + "[film]\nexposure_stops = 2\n").film.exposure, ExposureMode::fixed);
    EXPECT_EQ(scene_of(sky + "[film]\nwhite_luminance_cd_m2 = 1\n").film.exposure,
              ExposureMode::fixed);
    EXPECT_EQ(scene_of(sky + "[film]\nwidth = 10\n").film.exposure, ExposureMode::automatic);
}

}  // namespace
}  // namespace dewbow
