// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/paper_fog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kRounding = 1e-12;
constexpr Length kInfinitelyFar = std::numeric_limits<double>::infinity() * m;
constexpr std::array<double, 2> kMiddle{0.5, 0.5};
/// From a sun 20° high in the west.
const Dir<World> kAntisolar{normalised({1.0, -std::tan(20.0 * std::numbers::pi / 180.0), 0.0})};

/// A direction `r` from the antisolar point, the position angle `around` about it.
Dir<World> at(Angle r, Angle around = 0.7 * rad) {
    const Tangents across = tangents_of(kAntisolar.v);
    return {kAntisolar.v * cos(r) + (across.t * cos(around) + across.b * sin(around)) * sin(r)};
}

PaperRainbow rings_by_angle() {
    PaperRings rings;
    rings.bow.index = ImpressionisticBow::Index::by_angle;
    PaperRainbow rainbow;
    rainbow.bow = rings;
    return rainbow;
}

PaperMethod quick_table() {
    PaperMethod method;
    method.rays = 0;
    return method;
}

/// Of each channel, infinitely far away at `r` from the antisolar point.
std::array<double, 3> replaced_far_away(const PaperFog& fog, Angle r) {
    return fog.on_ray(at(r), kInfinitelyFar, kMiddle).value().replaced.v;
}

TEST(PaperFog, RingsStandWhereTheyAreToldAndAreRedOutside) {
    const PaperFog fog(rings_by_angle(), kAntisolar);
    const auto colours = linear_spectrum_samples();
    constexpr double kRing_deg = 2.0 / kPaperSamples;
    for (int k = 0; k < kPaperSamples; ++k)
        for (const double place : {0.01, 0.5, 0.99})  // of the ring, from outside
            for (const double around : {0.0, 2.0, 4.0}) {
                const Angle r = (43.0 - (k + place) * kRing_deg) * deg;
                const auto share = fog.on_ray(at(r, around * rad), 1.0 * m, kMiddle);
                ASSERT_TRUE(share);
                EXPECT_EQ(share->colour, colours[std::size_t(k)]);
            }
    for (const double r : {0.0, 40.99, 43.01, 90.0, 180.0})
        EXPECT_FALSE(fog.on_ray(at(r * deg), 1.0 * m, kMiddle)) << r;
}

TEST(PaperFog, JitterMovesTheRing) {
    PaperRainbow rainbow = rings_by_angle();
    std::get<PaperRings>(rainbow.bow).bow.jitter = {2.0, true};
    const PaperFog fog(rainbow, kAntisolar);
    const Dir<World> middle = at(42.0 * deg);  // of ring 6
    const auto colour = [&](double index, double within) {
        return fog.on_ray(middle, 1.0 * m, {index, within})->colour;
    };
    // A ring further in or out, and anywhere in its part of the spectrum.
    EXPECT_EQ(colour(0.0, 0.5), linear_spectrum_samples()[5]);
    EXPECT_EQ(colour(0.9999, 0.5), linear_spectrum_samples()[7]);
    EXPECT_EQ(colour(0.5, 0.25), linear_spectrum_colour(6.25 / kPaperSamples));
    EXPECT_FALSE(fog.on_ray(at(42.95 * deg), 1.0 * m, {0.0, 0.5}));  // out of the bow
}

TEST(PaperFog, EquationIsTheClosedForm) {
    PaperRainbow rainbow = rings_by_angle();
    std::get<PaperRings>(rainbow.bow).transmittance = {{1.0, 2.0, 4.0}};
    rainbow.constant = 1.0 / (200.0 * m);
    rainbow.depth = 500.0 * m;
    const PaperFog corrected(rainbow, kAntisolar);
    rainbow.equation = FogEquation::printed;
    const PaperFog printed(rainbow, kAntisolar);
    for (const double d : {0.0, 50.0, 500.0, 3000.0}) {
        const auto right = corrected.on_ray(at(42.0 * deg), d * m, kMiddle);
        const auto wrong = printed.on_ray(at(42.0 * deg), d * m, kMiddle);
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = std::min(d, 500.0) / 200.0 / std::exp2(double(c));
            EXPECT_NEAR(right->replaced[c], 1.0 - std::exp(-x), kRounding);
            // E10: what is left by the right one is the inverse of the printed one.
            EXPECT_NEAR(wrong->replaced[c] * (1.0 - right->replaced[c]), 1.0, kRounding);
            EXPECT_GE(wrong->replaced[c], 1.0);
        }
    }
}

TEST(PaperFog, TableReplacesEachChannelByItsOwnTransmittance) {
    PaperRainbow rainbow;
    rainbow.bow = quick_table();
    const PaperFog fog(rainbow, kAntisolar);
    const FogTable table = make_fog_table(quick_table());
    for (const double r : {0.35, 20.05, 40.95, 42.15, 42.65, 50.85, 52.75, 100.05, 179.95}) {
        const auto share = fog.on_ray(at(r * deg), 300.0 * m, kMiddle);
        EXPECT_EQ(share->colour, (Colour<LinearSrgb>{{1, 1, 1}}));  // no colour of its own
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(share->replaced[c],
                        1.0 - std::exp(-0.3 * table.intensity[std::size_t(r * 10.0)][c]), kRounding)
                << r;
    }
    // 63 % at the distance 1/h where the table is brightest.
    double most = 0.0;
    for (double r = 38.05; r < 46.0; r += 0.1)
        for (const double share : replaced_far_away(fog, r * deg)) most = std::max(most, share);
    EXPECT_NEAR(most, 1.0 - std::exp(-1.0), kRounding);
}

// E23: an infinite transmittance is no fog at any distance, any other is all fog infinitely far.
TEST(PaperFog, InfinityIsNothingOrEverything) {
    PaperRainbow rainbow;
    rainbow.bow = quick_table();
    rainbow.depth = kInfinitelyFar;
    const PaperFog fog(rainbow, kAntisolar);
    for (const double r : {46.0, 47.5, 49.0})  // Alexander's band
        for (const double share : replaced_far_away(fog, r * deg)) EXPECT_EQ(share, 0.0) << r;
    for (const double r : {5.0, 30.0, 40.0, 56.0, 120.0})
        for (const double share : replaced_far_away(fog, r * deg)) EXPECT_EQ(share, 1.0) << r;
    // Blue does not get as far out in the primary: there all that is red is replaced.
    const auto edge = replaced_far_away(fog, 42.0 * deg);
    EXPECT_EQ(edge[0], 1.0);
    EXPECT_EQ(edge[2], 0.0);
}

TEST(PaperFog, ChaosDividesTransmittances) {
    PaperRainbow rainbow = rings_by_angle();
    rainbow.chaos = Chaos{};
    rainbow.chaos->base_frequency = 5.0;
    const PaperFog fog(rainbow, kAntisolar);
    double least = 1.0, most = 0.0;
    for (double around = 0.0; around < 6.28; around += 0.1) {
        const Dir<World> direction = at(42.0 * deg, around * rad);
        const double density = chaos_density(direction.v, *rainbow.chaos);
        const auto share = fog.on_ray(direction, kInfinitelyFar, kMiddle);
        EXPECT_NEAR(-std::log1p(-share->replaced[1]), density, kRounding);
        least = std::min(least, density), most = std::max(most, density);
    }
    EXPECT_LT(least, 0.35);  // a bow of pieces
    EXPECT_GT(most, 0.65);
    rainbow.chaos->bias = -1.0;
    const PaperFog none(rainbow, kAntisolar);
    EXPECT_EQ(none.on_ray(at(42.0 * deg), kInfinitelyFar, kMiddle)->replaced[0], 0.0);
}

/// The sentence with which it is refused.
std::string refusal(const PaperRainbow& rainbow) {
    try {
        check_paper_rainbow(rainbow);
    } catch (const InputError& error) {
        return error.sentence();
    }
    return {};
}

TEST(PaperFog, RefusesWhatIsOutOfRange) {
    EXPECT_EQ(refusal({}), "");
    PaperRainbow rainbow = rings_by_angle();
    std::get<PaperRings>(rainbow.bow).bow.inner = 43.0 * deg;
    EXPECT_EQ(refusal(rainbow), "paper rainbow: its rings are of no width");
    rainbow = rings_by_angle();
    rainbow.depth = kInfinitelyFar;
    EXPECT_EQ(refusal(rainbow), "");
    rainbow.equation = FogEquation::printed;
    EXPECT_NE(refusal(rainbow), "");
    rainbow = {};
    rainbow.constant = InverseLength{};
    EXPECT_NE(refusal(rainbow), "");
    rainbow = {};
    rainbow.chaos = Chaos{};
    rainbow.chaos->octaves = 0;
    EXPECT_EQ(refusal(rainbow), "paper rainbow: octaves of chaos is 0; it must be 1 to 24");
}

}  // namespace
}  // namespace dewbow
