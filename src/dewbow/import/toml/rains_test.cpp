// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/rains.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "dewbow/import/toml/scene_toml.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow {
namespace {

/// Rays alone, which take no time.
#define DROPS "drop_radius_mm = 0.5\nmodel = \"descartes\"\n"

class RainsToml : public testing::Test {
protected:
    void SetUp() override { setenv("XDG_CACHE_HOME", testing::TempDir().c_str(), 1); }

    static Scene scene_of(const std::string& text) {
        return parse_scene_toml("scene.toml", text).scene;
    }
    static Rain rain_of(const std::string& keys) {
        return scene_of("[[rain]]\n" + keys).rains.at(0);
    }
    static double extinction_per_m(const Rain& rain) {
        const double lambda_nm = 550.0;
        double per_m = 0.0;
        rain.drops->extinction_lanes({&lambda_nm, 1}, {&per_m, 1});
        return per_m;
    }
    static void expect_refused(const std::string& keys, const std::string& phrase) {
        try {
            scene_of("[[rain]]\n" + keys);
            ADD_FAILURE() << keys << " was taken";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(phrase), std::string::npos) << error.what();
            EXPECT_GT(error.place().line, 0u) << error.what();
        }
    }
};

TEST_F(RainsToml, DensityByEachOfItsWays) {
    EXPECT_NEAR(extinction_per_m(rain_of(DROPS "region = \"everywhere\"\nextinction_per_km = 2")),
                2e-3, 1e-12);
    EXPECT_NEAR(extinction_per_m(
                    rain_of(DROPS "region = { type = \"layer\", bottom_m = 100, top_m = 600 }\n"
                                  "optical_depth = 0.25")),
                0.25 / 500.0, 1e-12);
    EXPECT_NEAR(
        rain_of(DROPS "region = \"everywhere\"\nrate_mm_per_h = 5").drops->rain_rate_mm_per_h(),
        5.0, 1e-9);
    EXPECT_NEAR(rain_of(DROPS "region = \"everywhere\"\ndrops_per_m3 = 300").drops->drops_per_m3(),
                300.0, 1e-9);
    // The law of the sizes has a number of its own: 8000 m⁻³ mm⁻¹ / Λ, Λ = 4.1 · 5^−0.21 / mm.
    EXPECT_NEAR(rain_of("drop_sizes = \"rain:marshall-palmer,rate=5mm/h\"\nmodel = \"descartes\"\n"
                        "region = \"everywhere\"")
                    .drops->drops_per_m3(),
                2736.0, 1.0);
}

TEST_F(RainsToml, RegionsAreWhereTheyAreSaid) {
    const auto contains = [](const Rain& rain, Vec3 p) {
        return std::get<ConvexRegion>(rain.region).contains({p});
    };
    const std::string dense = "extinction_per_km = 2\n" DROPS;
    EXPECT_TRUE(contains(rain_of(dense + "region = \"everywhere\""), {1e6, -1e6, 0.0}));
    const Rain layer = rain_of(dense + "region = { type = \"layer\", bottom_m = -5, top_m = 10 }");
    EXPECT_TRUE(contains(layer, {1e6, 9.9, 0.0}));
    EXPECT_FALSE(contains(layer, {0.0, 10.1, 0.0}));
    const Rain box = rain_of(dense +
                             "region = { type = \"box\", width_m = 2, height_m = 4, depth_m = 6, "
                             "position = [10, 0, 0], rotate_y_deg = 90, scale = 2 }");
    EXPECT_TRUE(contains(box, {15.9, 3.9, 1.9}));
    EXPECT_FALSE(contains(box, {15.9, 3.9, 2.1}));
    EXPECT_FALSE(contains(box, {16.1, 0.0, 0.0}));
    const Rain curtain = rain_of(
        dense +
        "region = { type = \"curtain\", from = [0, 0, -10], to = [10, 0, -10], thickness_m = 2, "
        "bottom_m = 0, top_m = 5 }");
    EXPECT_TRUE(contains(curtain, {5.0, 1.0, -10.9}));
    EXPECT_FALSE(contains(curtain, {5.0, 1.0, -11.1}));
    EXPECT_FALSE(contains(curtain, {10.1, 1.0, -10.0}));
}

TEST_F(RainsToml, PhasesAreAveragedOverTheSunsThatShine) {
    const Scene scene = scene_of(
        "[[rain]]\nregion = \"everywhere\"\nextinction_per_km = 1\n" DROPS
        "[[lights]]\ntype = \"distant\"\ndirection = [0, -1, 0]\nangular_radius_deg = 0.2666\n"
        "irradiance = 1\n[[lights]]\ntype = \"distant\"\ndirection = [0, -1, 0]\nirradiance = 1\n");
    const DropCloud& drops = *scene.rains.at(0).drops;
    ASSERT_EQ(drops.discs().size(), 2u);
    EXPECT_EQ(drops.disc_of({0.2666 * unit::deg, 0.0}), 1u);
    EXPECT_EQ(drops.disc_of({Angle{}, 0.0}), 0u);
}

TEST_F(RainsToml, ChaosMakesItUneven) {
    const std::string dense = "region = \"everywhere\"\nextinction_per_km = 2\n" DROPS;
    EXPECT_FALSE(rain_of(dense).chaos);
    const Rain uneven = rain_of(dense + "chaos = { size_m = 50, gain = 2.5, bias = -0.8 }");
    ASSERT_TRUE(uneven.chaos);
    EXPECT_NEAR(uneven.chaos->base_frequency, 1.0 / 50.0, 1e-12);
    EXPECT_EQ(uneven.chaos->gain, 2.5);
    EXPECT_EQ(uneven.chaos->bias, -0.8);
}

TEST_F(RainsToml, WrongRainsAreNamed) {
    const std::string everywhere = "region = \"everywhere\"\n";
    const std::string rain = everywhere + DROPS;
    expect_refused("", "rain 1 needs region");
    expect_refused(everywhere, "rain 1 needs drop_sizes, drop_radius_mm or drop_radius_um");
    expect_refused(rain, "rain 1 needs rate_mm_per_h, extinction_per_km, optical_depth or");
    expect_refused(rain + "rate_mm_per_hour = 5", "did you mean \"rate_mm_per_h\"?");
    expect_refused(rain + "rate_mm_per_h = 0", "rate_mm_per_h is 0");
    expect_refused(rain + "rate_mm_per_h = 5\ndrops_per_m3 = 5", "keep one");
    expect_refused(rain + "optical_depth = 1", "two parallel faces");
    expect_refused(everywhere + "drop_radius_mm = 0\nrate_mm_per_h = 5", "drop_radius_mm is 0");
    expect_refused(everywhere + "drop_radius_mm = 1000\nrate_mm_per_h = 5",
                   "drop_radius_mm is 1000");
    expect_refused(everywhere + "drop_sizes = \"1m\"\nrate_mm_per_h = 5", "expected 1 nm to 10 mm");
    expect_refused(everywhere + "drops = \"0.5mm\"\nrate_mm_per_h = 5", "drop_sizes");
    expect_refused(everywhere + "drop_radius_mm = 0.5\nmodel = \"airy\"\nrate_mm_per_h = 5",
                   "near its bows only");
    expect_refused(rain + "drop_shape = \"oblate\"\nrate_mm_per_h = 5", "flattened");
    expect_refused(rain + "drops_per_m3 = 1e9", "drops would fill 52.4 % of the air");
    const std::string layer = DROPS "region = { type = \"layer\", bottom_m = 0, top_m = 1e5 }\n";
    expect_refused(layer + "optical_depth = 1e9", "optical_depth is 1000000000");
    expect_refused(layer + "extinction_per_km = 1e3", "has an optical depth of 1e+05");
    expect_refused(DROPS
                   "rate_mm_per_h = 5\nregion = { type = \"layer\", bottom_m = 3, top_m = 3 }",
                   "no rain fits between");
    expect_refused(DROPS "rate_mm_per_h = 5\nregion = { type = \"lair\" }",
                   "did you mean \"layer\"");
    expect_refused(DROPS "rate_mm_per_h = 5\nregion = \"anywhere\"", "everywhere");
}

}  // namespace
}  // namespace dewbow
