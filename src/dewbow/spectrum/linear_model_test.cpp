// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/linear_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewbow {
namespace {

using namespace unit;
/// Sums of a dozen numbers between 0 and 1.
constexpr double kRounding = 1e-13;

TEST(LinearSpectrum, SamplesAtAnyCommonOffsetSumToWhite) {
    for (double offset : {0.0, 0.1, 0.25, 0.5, 0.77, 0.999}) {
        Colour<LinearSrgb> sum;
        for (int k = 0; k < kPaperSamples; ++k)
            sum = sum + linear_spectrum_colour((k + offset) / kPaperSamples);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], kPaperWhite, kRounding) << offset;
    }
}

TEST(LinearSpectrum, SamplesAreTheOnesRebuilt) {
    const double expected[kPaperSamples][3] = {
        {.5, 0, 0},  {1, .25, 0}, {1, .75, 0}, {.75, 1, 0}, {.25, 1, 0}, {0, 1, 0},  {0, 1, .5},
        {0, .75, 1}, {0, .25, 1}, {.25, 0, 1}, {.75, 0, 1}, {1, 0, 1},   {.5, 0, .5}};
    const auto samples = linear_spectrum_samples();
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(samples[k][c], expected[k][c], kRounding);
}

TEST(LinearSpectrum, ShowsWhatTheTextSaysOfFigure41) {
    // Magenta violet uses "a significant portion of the power available to the red primary" …
    double red = 0.0, violet = 0.0;
    constexpr int kSteps = 13 * 64;
    for (int k = 0; k < kSteps; ++k) {
        const double f = (k + 0.5) / kSteps, r = linear_spectrum_colour(f)[0];
        (f < 0.5 ? red : violet) += r;
    }
    EXPECT_NEAR(violet / (red + violet), 0.42, 0.005);
    // … and what is left of white without violet, then without more, is greenish, yellow, red,
    // black.
    const auto samples = linear_spectrum_samples();
    Colour<LinearSrgb> left = {{kPaperWhite, kPaperWhite, kPaperWhite}};
    left = left - samples[12];
    EXPECT_GT(left[1], left[0]);
    EXPECT_GT(left[1], left[2]);
    for (std::size_t k = 11; k >= 7; --k) left = left - samples[k];
    EXPECT_NEAR(left[2] / kPaperWhite, 0.083, 0.001);  // yellow: hardly any blue
    for (std::size_t k = 6; k >= 2; --k) left = left - samples[k];
    EXPECT_GT(left[0], 5.0 * left[1]);
}

TEST(LinearSpectrum, CoordinateGoesThereAndBack) {
    constexpr double kRelative = 1e-12;
    for (SpectralSpacing spacing : {SpectralSpacing::frequency, SpectralSpacing::wavelength})
        for (double f : {0.0, 0.3, 0.5, 1.0})
            EXPECT_NEAR(paper_coordinate(paper_wavelength(f, spacing), spacing), f, kRelative);
    EXPECT_NEAR(paper_wavelength(0.0, SpectralSpacing::frequency).to(nm), 800.0, 1e-9);
    EXPECT_NEAR(paper_wavelength(1.0, SpectralSpacing::wavelength).to(nm), 380.0, 1e-9);
    // Middles of the intervals, evenly in frequency.
    EXPECT_NEAR(paper_wavelength(0.5 / 13, SpectralSpacing::frequency).to(nm), 767.4, 0.05);
    EXPECT_NEAR(paper_wavelength(12.5 / 13, SpectralSpacing::frequency).to(nm), 387.8, 0.05);
}

TEST(LinearSpectrum, IsBlackOutside) {
    for (double f : {-0.1, 0.0, 1.0, 1.1, std::nan("")})
        EXPECT_EQ(linear_spectrum_colour(f), (Colour<LinearSrgb>{})) << f;
}

}  // namespace
}  // namespace dewbow
