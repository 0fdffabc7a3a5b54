// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectral_samples.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// Sums of at most 100 numbers between 0 and 1.
constexpr double kRounding = 1e-12;

const std::vector<Jitter> kJitters{Jitter::none, Jitter::index, Jitter::colour, Jitter::both};

std::vector<SpectralSample> drawn(const PreparedSpectralSampling& prepared,
                                  const std::vector<double>& offsets) {
    std::vector<SpectralSample> samples(std::size_t(prepared.sampling().samples));
    draw_spectral_samples(prepared, offsets, samples);
    return samples;
}

MonitorRgb sum_of(const std::vector<SpectralSample>& samples) {
    MonitorRgb sum;
    for (const SpectralSample& sample : samples) sum = sum + sample.rgb;
    return sum;
}

void expect_white(const MonitorRgb& sum, double tolerance = kRounding) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0, tolerance) << c;
}

TEST(SpectralSamples, ThirteenFixedAreThoseOfTheFigure) {
    const PreparedSpectralSampling prepared(make_spectral_model({}), {});
    EXPECT_EQ(prepared.offset_count(), 0u);
    const auto samples = drawn(prepared, {});
    const auto expected = linear_spectrum_samples();
    for (std::size_t k = 0; k < 13; ++k) {
        EXPECT_NEAR(samples[k].f_index, (double(k) + 0.5) / 13.0, kRounding);
        EXPECT_EQ(samples[k].f_index, samples[k].f_colour);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(samples[k].rgb[c], expected[k][c] / 6.0, kRounding);
    }
    expect_white(sum_of(samples));
}

TEST(SpectralSamples, JitterMovesWhatItNames) {
    for (Jitter jitter : kJitters) {
        for (bool correlated : {false, true}) {
            SCOPED_TRACE(jitter_names()[std::size_t(jitter)] + (correlated ? " correlated" : ""));
            const PreparedSpectralSampling prepared(
                make_spectral_model({}),
                {.samples = 3, .jitter = jitter, .correlated = correlated});
            const std::size_t count = jitter == Jitter::none ? 0 : correlated ? 1 : 3;
            ASSERT_EQ(prepared.offset_count(), count);
            std::vector<double> offsets{0.1, 0.7, 0.9};
            offsets.resize(count);
            const auto samples = drawn(prepared, offsets);
            for (std::size_t k = 0; k < 3; ++k) {
                const double fixed = (double(k) + 0.5) / 3.0;
                const double offset = offsets.empty() ? 0.5 : offsets[correlated ? 0 : k];
                const double moved = (double(k) + offset) / 3.0;
                const bool index = jitter == Jitter::index || jitter == Jitter::both;
                const bool colour = jitter == Jitter::colour || jitter == Jitter::both;
                EXPECT_NEAR(samples[k].f_index, index ? moved : fixed, kRounding);
                EXPECT_NEAR(samples[k].f_colour, colour ? moved : fixed, kRounding);
                if (!colour) continue;
                const auto rgb = linear_spectrum_colour(moved) * (13.0 / 6.0 / 3.0);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(samples[k].rgb[c], rgb[c], kRounding);
            }
        }
    }
}

TEST(SpectralSamples, FixedColoursAreWhiteForEveryNumberAndModel) {
    for (auto colours : {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie})
        for (int samples : {5, 7, 13, 31, 100})
            for (Jitter jitter : {Jitter::none, Jitter::index})
                for (bool tailored : {false, true}) {
                    const PreparedSpectralSampling prepared(
                        make_spectral_model({.colours = colours}),
                        {samples, jitter, false, tailored});
                    const std::vector<double> offsets(prepared.offset_count(), 0.3);
                    expect_white(sum_of(drawn(prepared, offsets)));
                }
}

TEST(SpectralSamples, OneFixedSampleIsRefusedAndOneJitteredIsNot) {
    const auto model = make_spectral_model({});
    try {
        const PreparedSpectralSampling prepared(model, {.samples = 1});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.sentence(),
                  "spectral samples of fixed colour: 1 leave red, green or blue without light; "
                  "expected more of them, or jitter of the colour");
    }
    const PreparedSpectralSampling jittered(model, {.samples = 1, .jitter = Jitter::both});
    EXPECT_EQ(jittered.sample(0, 0.5).rgb[0], 0.0);
}

TEST(SpectralSamples, MovingColoursAreWhiteOnAverage) {
    // The mean over offsets at the middles of 1000 cells is the integral over each interval by the
    // rule of the middle; its error is worst for one sample, 7e-5 by measurement (the steps of the
    // tailored distribution), and falls with the square of the number of offsets.
    constexpr int kOffsets = 1000;
    constexpr double kTolerance = 1e-4;
    for (auto colours : {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie})
        for (int samples : {1, 7, 13})
            for (bool tailored : {false, true}) {
                SCOPED_TRACE(testing::Message() << int(colours) << ' ' << samples << tailored);
                const PreparedSpectralSampling prepared(make_spectral_model({.colours = colours}),
                                                        {samples, Jitter::both, true, tailored});
                MonitorRgb mean;
                for (int i = 0; i < kOffsets; ++i)
                    mean = mean + sum_of(drawn(prepared, {(i + 0.5) / kOffsets}));
                expect_white(mean * (1.0 / kOffsets), kTolerance);
            }
}

TEST(SpectralSamples, TailoredOnesCarryTheSameLightEach) {
    // Intervals of equal area: each of N samples has 3/N of r + g + b, wherever it lies in its
    // interval. Within a cell of the distribution the density is constant and the curve is not.
    constexpr double kCell = 0.01;
    const PreparedSpectralSampling prepared(
        make_spectral_model({}), {.jitter = Jitter::both, .correlated = true, .tailored = true});
    for (double u : {0.05, 0.4, 0.95})
        for (const SpectralSample& sample : drawn(prepared, {u}))
            EXPECT_NEAR(sample.rgb[0] + sample.rgb[1] + sample.rgb[2], 3.0 / 13.0,
                        kCell * 3.0 / 13.0);
}

}  // namespace
}  // namespace dewbow
