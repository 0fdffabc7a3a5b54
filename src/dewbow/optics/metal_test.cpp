// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/metal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// ((n − 1)² + k²) / ((n + 1)² + k²)
double normal_reflectance(const Metal& metal, double nm) {
    const std::complex<double> index = metal.index(nm * unit::nm);
    return std::norm(index - 1.0) / std::norm(index + 1.0);
}

TEST(Metals, SpanTheVisibleRangeAndSayWhereTheyAreFrom) {
    std::set<std::string> names;
    for (const Metal& metal : metal_catalogue()) {
        EXPECT_TRUE(names.insert(metal.name).second) << metal.name << " is there twice";
        EXPECT_TRUE(metal.name.starts_with("metal/")) << metal.name;
        EXPECT_FALSE(metal.description.empty() || metal.source.empty()) << metal.name;
        EXPECT_EQ(metal.licence, "CC0-1.0") << metal.name;
        EXPECT_LE(metal.lambda_min_nm, kLambdaMin_nm) << metal.name;
        EXPECT_GE(metal.lambda_max_nm, kLambdaMax_nm) << metal.name;
        for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0) {
            const auto index = metal.index(nm * unit::nm);
            ASSERT_GT(index.real(), 0.0) << metal.name << " at " << nm;
            ASSERT_GT(index.imag(), 0.0) << metal.name << " at " << nm;
        }
    }
}

TEST(Metals, ReflectAsMirrorsOfThemWereMeasuredTo) {
    struct Published {
        const char* metal;
        double share;  ///< by which films of one metal differ
        double r[7];   ///< at 400, 450 … 700 nm
    };
    // Freshly evaporated films: G. Hass in American Institute of Physics Handbook, 3rd ed. (1972),
    // section 6g. Another group's films than those of the catalogue: gold and copper differ most
    // where their reflectance climbs, by 3 % of 1.
    constexpr Published kPublished[] = {
        {"aluminium", 0.01, {0.924, 0.922, 0.918, 0.915, 0.911, 0.905, 0.897}},
        {"silver", 0.012, {0.956, 0.971, 0.979, 0.983, 0.986, 0.988, 0.989}},
        {"gold", 0.035, {0.387, 0.387, 0.477, 0.817, 0.919, 0.955, 0.970}},
        {"copper", 0.035, {0.475, 0.552, 0.600, 0.669, 0.933, 0.966, 0.975}},
        {"platinum", 0.015, {0.663, 0.691, 0.714, 0.734, 0.752, 0.764, 0.772}},
        {"rhodium", 0.025, {0.761, 0.760, 0.766, 0.782, 0.797, 0.811, 0.820}},
    };
    for (const Published& published : kPublished) {
        for (int i = 0; i < 7; ++i) {
            const double nm = 400.0 + 50.0 * i;
            EXPECT_NEAR(normal_reflectance(find_metal(published.metal), nm), published.r[i],
                        published.share)
                << published.metal << " at " << nm;
        }
    }
}

/// The metal's colour in the light of D65, seen head on.
Colour<LinearSrgb> colour_of(const char* name) {
    const Metal& metal = find_metal(name);
    std::vector<double> lambda_nm, reflected, white;
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0) {
        lambda_nm.push_back(nm);
        white.push_back((*find_illuminant("D65"))(nm * unit::nm));
        reflected.push_back(white.back() * normal_reflectance(metal, nm));
    }
    const auto xyz = xyz_from_spectrum(*make_tabulated(lambda_nm, reflected, OutsideTable::zero));
    return rgb_from_xyz<LinearSrgb>(xyz * (1.0 / cie_y_integral()));
}

TEST(Metals, HaveTheColoursThatPeopleSee) {
    const auto gold = colour_of("gold"), copper = colour_of("copper"), silver = colour_of("silver");
    const auto brass = colour_of("brass"), electrum = colour_of("electrum");
    // Gold is yellow, copper is redder than gold: less green, and more blue.
    EXPECT_GT(gold[0], gold[1]);
    EXPECT_GT(gold[1], 1.5 * gold[2]);
    EXPECT_GT(copper[0], 1.3 * copper[1]);
    EXPECT_LT(copper[1] / copper[0], gold[1] / gold[0]);
    EXPECT_GT(copper[2] / copper[0], gold[2] / gold[0]);
    // Half silver pales it, and brass is yellow.
    EXPECT_GT(electrum[2] / electrum[0], gold[2] / gold[0]);
    EXPECT_GT(brass[1], 1.3 * brass[2]);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(silver[c], 0.98, 0.03);
}

// ---- Fresnel at a metal, on the catalogue's indices ----

/// |r_p|² from the angle of refraction, sin θ_t = sin θ_i / n, in complex numbers alone.
double parallel_by_complex_angle(double incidence, std::complex<double> n) {
    const std::complex<double> cos_t = std::sqrt(1.0 - std::pow(std::sin(incidence) / n, 2));
    const double cos_i = std::cos(incidence);
    return std::norm((n * cos_i - cos_t) / (n * cos_i + cos_t));
}

/// Where `f` is least in (0°, 90°): the best of 9000 steps.
template <class F>
double least_at_deg(F f) {
    double best_deg = 0.0;
    for (int i = 1; i < 9000; ++i) {
        if (f(i * 0.01 * kPi / 180.0) < f(best_deg * kPi / 180.0)) best_deg = i * 0.01;
    }
    return best_deg;
}

TEST(FresnelOfMetals, IsTheClosedFormAtNormalAndOneAtGrazingIncidence) {
    constexpr double kRounding = 1e-14;
    for (const Metal& metal : metal_catalogue()) {
        for (double nm : {400.0, 550.0, 700.0}) {
            const auto index = metal.index(nm * unit::nm);
            const auto normal = fresnel_conductor(1.0, index);
            EXPECT_NEAR(normal.parallel, normal_reflectance(metal, nm), kRounding) << metal.name;
            EXPECT_EQ(normal.parallel, normal.perpendicular) << metal.name;
            const auto grazing = fresnel_conductor(0.0, index);
            EXPECT_NEAR(grazing.parallel, 1.0, kRounding) << metal.name;
            EXPECT_NEAR(grazing.perpendicular, 1.0, kRounding) << metal.name;
        }
    }
}

TEST(FresnelOfMetals, HasItsLeastParallelReflectanceAtThePrincipalAngle) {
    constexpr double kStep_deg = 0.0101;
    for (const char* name : {"gold", "silver", "chromium", "mercury", "tungsten"}) {
        const auto index = find_metal(name).index(550.0 * unit::nm);
        const double here =
            least_at_deg([&](double i) { return fresnel_conductor(std::cos(i), index).parallel; });
        const double there =
            least_at_deg([&](double i) { return parallel_by_complex_angle(i, index); });
        EXPECT_NEAR(here, there, kStep_deg) << name;
        EXPECT_GT(here, 50.0) << name;
        // It is a true minimum, which no dielectric's zero is.
        EXPECT_GT(fresnel_conductor(std::cos(here * kPi / 180.0), index).parallel, 0.01) << name;
    }
}

TEST(FresnelOfMetals, TakesTheIndexOfTheOuterMedium) {
    // Under water gold is darker: at normal incidence ((n/w − 1)² + …) with w = 1.334.
    const auto gold = find_metal("gold").index(650.0 * unit::nm);
    const auto under_water = gold / 1.334;
    EXPECT_NEAR(fresnel_conductor(1.0, under_water).unpolarised(),
                std::norm(gold - 1.334) / std::norm(gold + 1.334), 1e-14);
}

std::string refusal(const char* name) {
    try {
        find_metal(name);
    } catch (const InputError& error) {
        return error.sentence() + "; " + error.hint();
    }
    return "found";
}

TEST(FindMetal, KnowsNamesAndSymbols) {
    EXPECT_EQ(find_metal("gold").name, "metal/gold");
    EXPECT_EQ(find_metal("Metal/Gold").name, "metal/gold");
    EXPECT_EQ(find_metal("au").name, "metal/gold");
    EXPECT_EQ(find_metal("W").name, "metal/tungsten");
    EXPECT_EQ(find_metal("red brass").name, "metal/red-brass");
    for (const Metal& metal : metal_catalogue()) EXPECT_EQ(&find_metal(metal.name), &metal);
}

TEST(FindMetal, NamesTheNearestOfAnUnknownMetal) {
    EXPECT_EQ(refusal("metal/silber"),
              "unknown metal \"metal/silber\"; did you mean metal/silver?");
    EXPECT_EQ(refusal("aluminum"), "unknown metal \"aluminum\"; did you mean metal/aluminium?");
    EXPECT_EQ(refusal("platinium"), "unknown metal \"platinium\"; did you mean metal/platinum?");
    EXPECT_NE(refusal("unobtainium of the seventh kind").find("known are metal/gold"),
              std::string::npos);
}

}  // namespace
}  // namespace dewbow
