// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/equivalents.h"

#include <gtest/gtest.h>

#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

IndexInAir glass(const char* name) { return index_in_air(make_dispersion(find_glass(name).data)); }
const DispersionUnit& unit_named(const std::string& name) {
    for (const DispersionUnit& row : dispersion_units())
        if (row.name == name) return row;
    throw std::out_of_range(name);
}

constexpr double kRounding = 1e-12;  // n_F − n_C is a hundredth of n

TEST(Equivalents, ComeBackFromTheTwoTermsThatTheyMake) {
    for (const DispersionUnit& unit : dispersion_units())
        for (double n_d : {1.33, 1.5168, 2.417})
            for (double b : {0.002, 0.0042, 0.03}) {
                const double value = unit.measure(two_terms(n_d, b));
                EXPECT_NEAR(unit.b_um2(n_d, value) / b, 1.0, kRounding) << unit.name;
                EXPECT_NEAR(unit.measure(two_terms(n_d, b)) / value, 1.0, kRounding);
            }
}

// N-BK7: SCHOTT's data sheet has n_F − n_C = 0.008054 and P_g,F = 0.5349.
TEST(Equivalents, AreThoseOfTheDataSheet) {
    const IndexInAir bk7 = glass("N-BK7");
    EXPECT_NEAR(unit_named("spread").measure(bk7), 0.008054, 5.1e-7);
    EXPECT_NEAR(unit_named("abbe").measure(bk7), 64.17, 5.1e-3);
    EXPECT_NEAR(unit_named("gltf").measure(bk7), 20.0 / 64.17, 3e-5);
    EXPECT_NEAR(partial_dispersion(bk7, 435.8343, kAirF_nm), 0.5349, 5.1e-5);
    // w is 1/V with D for d, by hand from the sheet's n_D = 1.51673.
    EXPECT_NEAR(dispersive_power(bk7), 0.008054 / 0.51673, 2e-6);
}

TEST(Equivalents, KnowTheFireOfDiamond) {
    EXPECT_NEAR(unit_named("fire").measure(glass("diamond")), 0.044, 1e-3);
    // POV-Ray's own file of constants has 1.035 for diamond, of n_G over n_B; ours is of its whole
    // spectrum, 380 to 730 nm.
    const double whole = unit_named("pov_ray").measure(glass("diamond"));
    EXPECT_GT(whole, 1.025);
    EXPECT_LT(whole, 1.035);
}

// Two numbers miss a dense flint by 7e-3.
TEST(Equivalents, MissTheTrueGlass) {
    const IndexInAir sf11 = glass("SF11");
    const double b = unit_named("abbe").b_um2(1.78472, 25.76);
    EXPECT_NEAR(worst_difference(two_terms(1.78472, b), sf11), 7e-3, 1e-3);
}

}  // namespace
}  // namespace dewbow
