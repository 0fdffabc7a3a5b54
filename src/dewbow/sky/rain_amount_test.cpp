// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/rain_amount.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

// Another paper's curve through the same measurements, stated for 0.6 to 5.8 mm across: v = 9.65 −
// 10.3 e^{−0.6 D/mm} m/s "within 2 %".   [Atlas, Srivastava & Sekhon, Rev. Geophys. 11, 1 (1973)]
TEST(RainAmount, DropsFallAsMeasured) {
    constexpr double kFit = 0.025;
    for (double diameter = 0.6; diameter <= 5.8; diameter += 0.05) {
        const double fit = 9.65 - 10.3 * std::exp(-0.6 * diameter);
        EXPECT_NEAR(fall_speed(0.5 * diameter * mm) / fit, 1.0, kFit) << diameter;
    }
    // Stokes: 2/9 · 998 kg m⁻³ · 9.81 m s⁻² r² / 1.82e-5 Pa s = 1.2e8 r² m⁻¹ s⁻¹, less Oseen's
    // 10 % at 0.1 mm.
    EXPECT_NEAR(fall_speed(20.0 * um) / (1.2e8 * 20e-6 * 20e-6), 0.9, 0.05);
}

double section(const RainAmount& amount, const DropSizesPtr& sizes, double efficiency = 1.0) {
    return cross_section_per_volume(amount, std::array{sizes}, efficiency);
}

TEST(RainAmount, OneSizeByHand) {
    // 1000 drops of 1 mm across in a cubic metre: 1000 π (0.5 mm)²; they fall at 4.03 m/s.
    const DropSizesPtr sizes = single_drop_size(0.5 * mm);
    const double by_hand = 1000.0 * std::numbers::pi * 0.25e-6;
    EXPECT_NEAR(section(DropsPerVolume{1000.0}, sizes) / by_hand, 1.0, 1e-12);
    const double rate = 1000.0 * std::numbers::pi / 6.0 * 1e-9 * 4.03 * 3.6e6;
    EXPECT_NEAR(section(RainRate{rate}, sizes) / by_hand, 1.0, 1e-12);
    EXPECT_NEAR(section(RainExtinction{2.0 * by_hand}, sizes, 2.0) / by_hand, 1.0, 1e-12);
    EXPECT_NEAR(by_hand * water_per_cross_section(std::array{sizes}),
                1000.0 * std::numbers::pi / 6.0 * 1e-9, 1e-18);
}

// Atlas & Ulbrich: optical extinction of rain is about 0.2 R^{0.67} per km (twice the cross
// section) [Atlas, J. Meteor. 10, 486 (1953): visual range of rain; Ulbrich & Atlas, J. Appl.
// Meteor. 24, 580 (1985)] Laws of sizes differ by half.
TEST(RainAmount, RainDimsAsMuchAsRainDoes) {
    const DropSizesPtr sizes = marshall_palmer_drop_sizes(5.0);
    const double twice_per_km = 2e3 * section(RainRate{5.0}, sizes);
    EXPECT_GT(twice_per_km, 0.5 * 0.2 * std::pow(5.0, 0.67));
    EXPECT_LT(twice_per_km, 2.0 * 0.2 * std::pow(5.0, 0.67));
}

// Two kinds with the same cross section each: their numbers are as 1 / r².
TEST(RainAmount, ShowersShareTheCrossSection) {
    const std::array showers{single_drop_size(0.2 * mm), single_drop_size(0.4 * mm)};
    const double c = cross_section_per_volume(DropsPerVolume{5000.0}, showers, 1.0);
    // N₁ = 4 N₂, N₁ + N₂ = 5000.
    EXPECT_NEAR(c, std::numbers::pi * (4000.0 * 0.04e-6 + 1000.0 * 0.16e-6), 1e-12);
}

TEST(RainAmount, NothingIsRefused) {
    const DropSizesPtr sizes = single_drop_size(0.5 * mm);
    for (const RainAmount& amount : {RainAmount{DropsPerVolume{0.0}}, RainAmount{RainRate{-1.0}},
                                     RainAmount{RainExtinction{0.0}}})
        EXPECT_THROW(section(amount, sizes), InputError);
}

}  // namespace
}  // namespace dewbow
