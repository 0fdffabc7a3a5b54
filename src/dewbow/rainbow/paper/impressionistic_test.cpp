// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/impressionistic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/rainbow/paper/fog.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kRounding = 1e-12;

TEST(Fog, ReplacesNothingNearAndEverythingFar) {
    const InverseLength h = 1.0 / (100.0 * m);
    EXPECT_EQ(fog_replacement(h, 0.0 * m, 1.0), 0.0);
    EXPECT_NEAR(fog_replacement(h, 100.0 * m, 1.0), 1.0 - std::exp(-1.0), kRounding);
    EXPECT_EQ(fog_replacement(h, std::numeric_limits<double>::infinity() * m, 3.0), 1.0);
    const double no_fog = std::numeric_limits<double>::infinity();
    EXPECT_EQ(fog_replacement(h, no_fog * m, no_fog), 0.0);
    // As printed it has replaced all of the colour before the ray has gone anywhere, and then more.
    EXPECT_EQ(fog_replacement_as_printed(h, 0.0 * m, 1.0), 1.0);
    EXPECT_GT(fog_replacement_as_printed(h, 100.0 * m, 1.0), 2.7);
}

TEST(ImpressionisticBow, CosineAndAngleAgreeAtTheEdgesAndNearlyBetween) {
    const Angle outer = 43.0 * deg, inner = 41.0 * deg;
    const double width = kPaperSamples / (cos(inner) - cos(outer));
    EXPECT_NEAR(published_ring_index(cos(outer), cos(outer), width), 0.0, kRounding);
    EXPECT_NEAR(published_ring_index(cos(inner), cos(outer), width), 13.0, 1e-10);
    EXPECT_NEAR(ring_index(outer, outer, inner), 0.0, kRounding);
    EXPECT_NEAR(ring_index(inner, outer, inner), 13.0, kRounding);
    // sin θ varies by 4 % over the bow: no more than an eighth of a ring.
    for (double r = 41.0; r <= 43.0; r += 0.1)
        EXPECT_NEAR(published_ring_index(cos(r * deg), cos(outer), width),
                    ring_index(r * deg, outer, inner), 0.125);
}

TEST(ImpressionisticBow, AnglesForCosinesGiveNoBow) {
    // E11: parameters by the names that the snippet gives them. In degrees no ray has a fog …
    int fogs = 0;
    for (double r = 0.0; r <= 180.0; r += 0.1) {
        const double index = published_ring_index(cos(r * deg), 42.0, 2.0);
        fogs += index >= 0.0 && index < kPaperSamples;
    }
    EXPECT_EQ(fogs, 0);
    // … and in radians one, red, fills a disc of 42.8°: cos r = r at 42.35°.
    for (double r : {0.0, 20.0, 42.8})
        EXPECT_EQ(std::floor(published_ring_index(cos(r * deg), (42.0 * deg).to(rad),
                                                  (2.0 * deg).to(rad))),
                  0.0);
    EXPECT_LT(published_ring_index(cos(42.9 * deg), (42.0 * deg).to(rad), (2.0 * deg).to(rad)),
              0.0);
}

TEST(ImpressionisticBow, IsRedOutsideAndThereIsNoFogBeside) {
    const std::array<double, 2> u{0.3, 0.8};
    const auto samples = linear_spectrum_samples();
    EXPECT_EQ(*ring_fog(0.0, {}, u), samples[0]);
    EXPECT_EQ(*ring_fog(12.99, {}, u), samples[12]);
    for (double index : {-0.5, -1e-9, 13.0, std::nan("")}) EXPECT_FALSE(ring_fog(index, {}, u));
}

TEST(ImpressionisticBow, JitterStaysWithinItsWidth) {
    const auto samples = linear_spectrum_samples();
    // δ = 1 around 6.5 never leaves ring 6; δ = 2 reaches its neighbours, each a quarter of times.
    constexpr int kSamples = 4096;
    int own = 0;
    for (int s = 0; s < kSamples; ++s) {
        const std::array<double, 2> u{(s + 0.5) / kSamples, 0.0};
        EXPECT_EQ(*ring_fog(6.5, {1.0, false}, u), samples[6]);
        own += *ring_fog(6.5, {2.0, false}, u) == samples[6];
    }
    EXPECT_NEAR(double(own) / kSamples, 0.5, 1.0 / kSamples);
    // Colour jitter takes all of the ring's interval, and its mean on a straight piece.
    double least = 1.0, most = 0.0, mean = 0.0;
    for (int s = 0; s < kSamples; ++s) {
        const double green = (*ring_fog(2.5, {0.0, true}, {0.5, (s + 0.5) / kSamples}))[1];
        least = std::min(least, green), most = std::max(most, green);
        mean += green / kSamples;
    }
    EXPECT_NEAR(least, 0.5, 1e-3);
    EXPECT_NEAR(most, 1.0, 1e-3);
    EXPECT_NEAR(mean, samples[2][1], 1e-4);
}

TEST(ImpressionisticBow, StripBlursWithJitter) {
    std::vector<Angle> angles;
    for (int k = 0; k <= 300; ++k) angles.push_back((40.5 + 0.01 * k) * deg);
    const auto greatest_step = [&](const FogJitter& jitter) {
        ImpressionisticBow bow;
        bow.jitter = jitter;
        const auto strip = impressionistic_strip(bow, angles, 256, 1);
        double step = 0.0;
        for (std::size_t k = 1; k < strip.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                step = std::max(step, std::abs(strip[k][c] - strip[k - 1][c]));
        return step;
    };
    // A ring is 0.15° wide: 15 samples of the strip share a step that was one.
    EXPECT_GE(greatest_step({}), 0.5);
    EXPECT_LT(greatest_step({2.0, true}), 0.1);
}

}  // namespace
}  // namespace dewbow
