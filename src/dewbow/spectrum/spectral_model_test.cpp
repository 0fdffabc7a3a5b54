// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectral_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/linear_model.h"
#include "dewbow/spectrum/monitors.h"

namespace dewbow {
namespace {

using namespace unit;

std::vector<SpectralModelSettings> all_models() {
    std::vector<SpectralModelSettings> all;
    for (auto spacing : {SpectralSpacing::frequency, SpectralSpacing::wavelength}) {
        for (auto colours :
             {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie})
            all.push_back({colours, spacing, NegativeColours::clamp, "rogers"});
        for (auto negative : {NegativeColours::keep, NegativeColours::limit})
            all.push_back({SpectralColours::empirical, spacing, negative, "ntsc"});
    }
    return all;
}

TEST(SpectralModels, EachChannelIntegratesToOne) {
    // Middles of 47,000 cells, 100 a nanometre of the widest range. White of the CIE model is that
    // of xyz_from_spectrum, whose trapezoids of 0.5 nm are 3.7e-6 above the integral of b, the
    // product of two functions that are linear from nm to nm; the other sums are within 2e-7.
    constexpr int kCells = 47000;
    constexpr double kTolerance = 5e-6;
    for (const SpectralModelSettings& settings : all_models()) {
        const auto model = make_spectral_model(settings);
        MonitorRgb sum;
        for (int i = 0; i < kCells; ++i) sum = sum + model->density((i + 0.5) / kCells);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c] / kCells, 1.0, kTolerance)
                << int(settings.colours) << int(settings.spacing) << int(settings.negative) << c;
    }
}

TEST(SpectralModels, CoordinateGoesThereAndBack) {
    constexpr double kRounding = 1e-12;
    const double ends_nm[3][2] = {{800.0, 380.0}, {770.0, 380.0}, {830.0, 360.0}};
    for (const SpectralModelSettings& settings : all_models()) {
        const auto model = make_spectral_model(settings);
        EXPECT_NEAR(model->wavelength(0.0).to(nm), ends_nm[int(settings.colours)][0], 1e-9);
        EXPECT_NEAR(model->wavelength(1.0).to(nm), ends_nm[int(settings.colours)][1], 1e-9);
        for (double f : {-0.2, 0.0, 0.31, 0.5, 1.0, 1.3})
            EXPECT_NEAR(model->coordinate(model->wavelength(f)), f, kRounding);
        // Against a central difference, whose own error is h² λ''' / 6.
        constexpr double kH = 1e-5;
        const double slope = (model->wavelength(0.3 - kH) - model->wavelength(0.3 + kH)).to(nm);
        EXPECT_NEAR(model->nm_per_f(0.3) / (slope / (2.0 * kH)), 1.0, 1e-8);
    }
}

TEST(SpectralModels, LinearIsThePapersCurve) {
    const auto model = make_spectral_model({});
    for (double f : {0.01, 0.2, 0.55, 0.99})
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(model->density(f)[c] * kPaperWhite / kPaperSamples,
                        linear_spectrum_colour(f)[c], 1e-15);
}

TEST(SpectralModels, CieIsTheObserverUnderD65OnAnyMonitor) {
    constexpr double kRounding = 1e-12;
    const SpectrumPtr d65 = find_illuminant("D65");
    const double white_y = xyz_from_spectrum(*d65)[1];
    for (const MonitorRow& monitor : monitors()) {
        const auto model =
            make_spectral_model({SpectralColours::cie, SpectralSpacing::wavelength,
                                 NegativeColours::clamp, std::string(monitor.primaries.name)});
        for (double lambda_nm : {400.0, 461.3, 555.0, 620.0, 777.7}) {
            const double f = model->coordinate(lambda_nm * nm);
            const auto xyz = model->xyz(model->density(f));
            const auto bar = cie_xyz_bar(lambda_nm);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(xyz[c] / 470.0, bar[c] * (*d65)(lambda_nm * nm) / white_y, kRounding);
        }
    }
}

TEST(SpectralModels, OneOfEachChannelIsTheWhiteOfTheFilm) {
    // x, y of CIE 15 for D65, to the four digits that the film's primaries have.
    constexpr double kFourDigits = 5e-5;
    for (const MonitorRow& monitor : monitors()) {
        const auto model =
            make_spectral_model({SpectralColours::linear, SpectralSpacing::frequency,
                                 NegativeColours::clamp, std::string(monitor.primaries.name)});
        const auto white = model->xyz({{1.0, 1.0, 1.0}});
        const double sum = white[0] + white[1] + white[2];
        EXPECT_NEAR(white[1], 1.0, 1e-13);
        EXPECT_NEAR(white[0] / sum, 0.3127, kFourDigits);
        EXPECT_NEAR(white[1] / sum, 0.3290, kFourDigits);
        // and a primary has the chromaticity of the row
        const auto red = model->xyz({{1.0, 0.0, 0.0}});
        EXPECT_NEAR(red[0] / (red[0] + red[1] + red[2]), monitor.primaries.red[0], 1e-13);
    }
}

TEST(SpectralModels, AreBlackOutside) {
    for (const SpectralModelSettings& settings : all_models())
        for (double f : {-0.1, 1.1, std::nan("")})
            EXPECT_EQ(make_spectral_model(settings)->density(f), MonitorRgb{}) << f;
}

TEST(Monitors, UnknownOneIsRefusedWithTheNearest) {
    try {
        make_spectral_model({.monitor = "rodgers"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.sentence(), "unknown monitor \"rodgers\"");
        EXPECT_EQ(error.hint(), "did you mean \"rogers\"?");
    }
}

}  // namespace
}  // namespace dewbow
