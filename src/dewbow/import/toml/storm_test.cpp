// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/storm.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;  ///< of unit conversions

TEST(Storm, SaysNothingWhereNothingIsSaid) {
    const Storm storm = parse_storm("storm.toml", "");
    EXPECT_TRUE(storm.models.empty() && storm.orders.empty() && storm.sizes.empty() &&
                !storm.index);
    EXPECT_TRUE(storm.wavelengths.empty() && storm.angles.empty() && !storm.sun_altitude);
}

TEST(Storm, ReadsEveryKey) {
    const Storm storm = parse_storm("storm.toml", R"(
model = ["mie", "descartes"]
orders = [2, 3]
tolerance = 0.01
drop_radius_um = 300
drop_shape = "oblate"
drop_oscillation = 0.2
drop_tilt_deg = 3
water = "water@10C"
air = "vacuum"
illuminant = "A"
sun_altitude_deg = 5
sun_radius_deg = 0.25
limb_darkening = 0.6
sun_reddened = true
haze_depth = 0.2
wavelengths_nm = { from = 400, to = 700, step = 100 }
angles_deg = [0, 60, 137.5]
polarisation = "parallel"
polariser_deg = 90
clock_angle_deg = -45
)");
    EXPECT_EQ(storm.models, (std::vector<std::string>{"mie", "descartes"}));
    EXPECT_EQ(storm.orders, (Orders{2, 3}));
    EXPECT_EQ(storm.tolerance, 0.01);
    EXPECT_NEAR(storm.sizes.front()->smallest().to(unit::mm), 0.3, kRounding);
    EXPECT_EQ(storm.water->name, "fluid/water@10C");
    EXPECT_EQ(storm.air->name, "fluid/vacuum");
    EXPECT_EQ(storm.illuminant->name, "illuminant/A");
    EXPECT_NEAR(storm.sun_altitude->to(unit::deg), 5.0, kRounding);
    EXPECT_NEAR(storm.sun_radius->to(unit::deg), 0.25, kRounding);
    EXPECT_EQ(storm.limb_darkening, 0.6);
    EXPECT_EQ(storm.reddened, true);
    EXPECT_EQ(storm.haze, 0.2);
    EXPECT_EQ(storm.shape, DropShape::oblate);
    EXPECT_EQ(storm.oscillation, 0.2);
    EXPECT_NEAR(storm.tilt->to(unit::deg), 3.0, kRounding);
    EXPECT_NEAR(storm.clock_angle->to(unit::deg), -45.0, kRounding);
    ASSERT_EQ(storm.wavelengths.size(), 4u);
    EXPECT_EQ(storm.wavelengths.back(), 700.0 * unit::nm);
    ASSERT_EQ(storm.angles.size(), 3u);
    EXPECT_EQ(storm.angles.back(), 137.5 * unit::deg);
    EXPECT_EQ(storm.polarisation, Polarisation::parallel);
    EXPECT_NEAR(storm.polariser->to(unit::deg), 90.0, kRounding);
}

TEST(Storm, ReadsIndicesWithAndWithoutAbsorption) {
    EXPECT_EQ(parse_storm("s", "index = 1.333").index->n, 1.333);
    const Storm storm = parse_storm("s", "index = [1.33, 1e-8]");
    EXPECT_EQ(storm.index->n, 1.33);
    EXPECT_EQ(storm.index->k, 1e-8);
}

/// Each wrong file says where it is wrong, and what.
TEST(Storm, SaysWhatIsWrongAndWhere) {
    struct Row {
        const char *text, *said;
    };
    for (const Row& row : std::vector<Row>{
             {"drop_radius_mm = 0", "storm.toml:1:18: drop_radius_mm is 0; it must be between"},
             {"drop_radius_mm = -1", "drop_radius_mm is -1"},
             {"drop_radius_mm = nan", "drop_radius_mm is nan"},
             {"drop_radius_mm = 1000", "drop_radius_mm is 1000"},
             {"drop_radius_mm = \"big\"", "drop_radius_mm is the string"},
             {"drop_raduis_mm = 1", "did you mean \"drop_radius_mm\"?"},
             {"\nsun_altitude = 5", "storm.toml:2:1: unknown key \"sun_altitude\""},
             {"drop_radius_mm = 1\ndrop_sizes = \"1mm\"",
              "storm.toml:2:1: the storm file has both"},
             {"index = 1.3\nwater = \"water\"", "has both index and water; keep one"},
             {"index = 0.9", "index is 0.9"},
             {"index = [1.3]", "expected n or [n, k]"},
             {"model = \"mei\"", "did you mean \"mie\"?"},
             {"model = []", "model is an empty array"},
             {"orders = [8]", "orders is 8"},
             {"water = \"watr\"", "storm.toml:1:9: unknown glass \"watr\""},
             {"illuminant = \"D66\"", "storm.toml:1:14: unknown lamp \"D66\""},
             {"drop_sizes = \"gama:mean=1mm,width=0.1\"", "storm.toml:1:14: "},
             {"drop_sizes = []", "drop_sizes is an empty array"},
             {"drop_sizes = [\"1mm\", \"2mn\"]", "storm.toml:1:22: "},
             {"wavelengths_nm = [500, 400]", "storm.toml:1:24: wavelengths_nm[1] is 400 after 500"},
             {"wavelengths_nm = { from = 700, to = 400, step = 1 }", "it must ascend"},
             {"wavelengths_nm = { from = 400, to = 700, step = 1e-9 }", "more than 100000 steps"},
             {"angles_deg = 190", "angles_deg is 190"},
             {"polarisation = \"both\"", "unknown polarisation \"both\""},
         })
        try {
            parse_storm("storm.toml", row.text);
            ADD_FAILURE() << row.text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(row.said), std::string::npos)
                << row.text << "\n  " << error.what();
        }
}

TEST(Storm, MayHaveSeveralShowers) {
    const Storm storm = parse_storm("s", "drop_sizes = [\"0.2mm\", \"1mm\"]");
    ASSERT_EQ(storm.sizes.size(), 2u);
    EXPECT_NEAR(storm.sizes[1]->smallest().to(unit::mm), 1.0, kRounding);
}

TEST(Storm, OptionsStandAboveTheFile) {
    Storm file = parse_storm("s", "drop_radius_mm = 1\nwater = \"water@10C\"\norders = [2]");
    Storm options;
    options.index = ComplexIndex{1.5, 0.0};
    options.orders = {3};
    const Storm both = with_above(file, options);
    EXPECT_FALSE(both.water.has_value());
    EXPECT_EQ(both.index->n, 1.5);
    EXPECT_EQ(both.orders, (Orders{3}));
    EXPECT_NEAR(both.sizes.front()->smallest().to(unit::mm), 1.0, kRounding);
    EXPECT_EQ(with_above(file, {}).water->name, "fluid/water@10C");
}

TEST(Stepped, EndsWhereItShould) {
    EXPECT_EQ(stepped(380.0, 780.0, 5.0).size(), 81u);
    EXPECT_EQ(stepped(0.0, 180.0, 0.1).size(), 1801u);
    EXPECT_EQ(stepped(0.0, 180.0, 0.1).back(), 180.0);
    EXPECT_NEAR(stepped(0.0, 1.0, 0.3).back(), 0.9, kRounding);
    EXPECT_EQ(stepped(5.0, 5.0, 1.0), std::vector<double>{5.0});
}

}  // namespace
}  // namespace dewbow
