// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"

namespace dewbow {
namespace {

constexpr SpectralSpacing kSpacings[] = {SpectralSpacing::frequency, SpectralSpacing::wavelength};
constexpr double kRounding = 1e-13;
/// Indices and dispersive powers stated to so many figures, by hand from eq. 9.
constexpr double kThreeFigures = 5.1e-3;
/// Of dispersive powers: the lines in vacuum have 8 decimals of a nanometre.
constexpr double kLineDecimals = 1e-11;

double against_air(const DispersionPtr& n, Wavelength lambda) {
    return ((*n)(lambda) / (*air())(lambda)).value;
}
double at(const DispersionPtr& n, double f, SpectralSpacing spacing = SpectralSpacing::frequency) {
    return against_air(n, paper_wavelength(f, spacing));
}
double power(const DispersionPtr& n) { return dispersive_power(index_in_air(n)); }
std::string message_of(double eta_red, double w, IndexReading reading) {
    try {
        paper_index(eta_red, w, reading);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(PaperIndex, IsAStraightLineInTheCoordinateOfTheColours) {
    for (const SpectralSpacing spacing : kSpacings)
        for (const IndexReading reading : {IndexReading::intended, IndexReading::exact}) {
            const DispersionPtr n = paper_index(1.5, 0.03, reading, spacing);
            const LinearIndex line = linear_index(1.5, 0.03, reading, spacing);
            EXPECT_EQ(line.at_red, 1.5);
            for (double f = 0.0; f <= 1.0; f += 0.125)
                EXPECT_NEAR(at(n, f, spacing), 1.5 + line.slope * f, kRounding);
        }
}

// 0.5 · 3.2 / 0.76 = 2.105: the paper's own example, 4.2 and 0.5.
TEST(PaperIndex, TakesWhatIsOutlandish) {
    const DispersionPtr n = paper_index(4.2, 0.5, IndexReading::intended);
    EXPECT_NEAR(at(n, 0.0), 4.2, kRounding);
    EXPECT_NEAR(at(n, 1.0), 4.2 + 1.6 / 0.76, kRounding);
}

// (w(η − 1) − η)/0.76, by hand.
TEST(PaperIndex, AsPrintedIsNegativeAndNeverAMedium) {
    EXPECT_NEAR(linear_index(1.3288, 0.01788, IndexReading::printed).at(1.0), -1.74, kThreeFigures);
    EXPECT_NEAR(linear_index(4.2, 0.5, IndexReading::printed).at(1.0), -3.42, kThreeFigures);
    EXPECT_EQ(linear_index(4.2, 0.5, IndexReading::printed).at(0.0), 0.0);
    EXPECT_NE(message_of(4.2, 0.5, IndexReading::printed).find("-3.42 at the far violet"),
              std::string::npos);
}

TEST(PaperIndex, ExactHasItsDispersivePowerAndIntendedHasHalf) {
    for (const SpectralSpacing spacing : kSpacings)
        for (const double w : {0.0178, 0.0385, 0.5}) {
            const auto power_of = [&](IndexReading reading) {
                return power(paper_index(1.5, w, reading, spacing));
            };
            EXPECT_NEAR(power_of(IndexReading::exact), w, kLineDecimals);
            // κ/0.76, less what η_D exceeds the index at the far red by.
            const double share =
                paper_coordinate(kLineF, spacing) - paper_coordinate(kLineC, spacing);
            const double f_D = paper_coordinate(kLineD, spacing);
            EXPECT_NEAR(power_of(IndexReading::intended),
                        w * (share / 0.76) / (1.0 + w * f_D / 0.76), kLineDecimals);
        }
}

// κ and f_C, f_D, f_F of the lines in air, computed apart from this program; ours are in vacuum.
TEST(PaperIndex, HasTheSharesOfItsSpectrum) {
    constexpr double kAir = 5e-4;  // 2.8e-4 of 1/λ
    const auto f = [](Wavelength line, SpectralSpacing s) { return paper_coordinate(line, s); };
    const auto kFrequency = SpectralSpacing::frequency, kWavelength = SpectralSpacing::wavelength;
    EXPECT_NEAR(f(kLineC, kFrequency), 0.1981, kAir);
    EXPECT_NEAR(f(kLineD, kFrequency), 0.3235, kAir);
    EXPECT_NEAR(f(kLineF, kFrequency), 0.5841, kAir);
    EXPECT_NEAR(f(kLineF, kWavelength) - f(kLineC, kWavelength), 0.405, kAir);
}

/// Eq. 15: a = 1.3239, b = 3116.3 nm².
DispersionPtr paper_water() {
    return make_dispersion({"cauchy", {1.3239, 3116.3e-6}, IndexReference::air});
}

// η(380) − η(800) of the paper's water, computed apart from this program with lines in air:
// 0.01671; the line has 0.00773 as intended and 0.01546 exact.
TEST(PaperIndex, OfWaterHasHalfItsDispersion) {
    constexpr double kFourFigures = 1.5e-5;  // and 5.5e-4 of them for 1/λ² in air
    const DispersionPtr water = paper_water();
    const auto span_of = [](const DispersionPtr& n) {
        return against_air(n, kPaperViolet) - against_air(n, kPaperRed);
    };
    EXPECT_NEAR(span_of(water), 0.01671, kFourFigures);
    EXPECT_NEAR(span_of(paper_index_of(water, IndexReading::intended)), 0.00773, kFourFigures);
    EXPECT_NEAR(span_of(paper_index_of(water, IndexReading::exact)), 0.01546, kFourFigures);
}

// b (1/486.1327² − 1/656.2725²) / (a − 1 + b/589.2938²), by hand.
TEST(DispersivePower, OfThePapersWater) { EXPECT_NEAR(power(paper_water()), 0.017878, 6e-7); }

TEST(PaperIndex, OfARealGlassMeetsItAtTheFarRedAndHasItsPower) {
    for (const char* name : {"schott/N-BK7", "schott/SF11", "gem/diamond"}) {
        const DispersionPtr real = make_dispersion(find_glass(name).data);
        const DispersionPtr line = paper_index_of(real, IndexReading::exact);
        EXPECT_NEAR(against_air(line, kPaperRed), against_air(real, kPaperRed), kRounding) << name;
        EXPECT_NEAR(power(line), power(real), kLineDecimals) << name;
        EXPECT_EQ(paper_index_of(line, IndexReading::intended), line) << name;
    }
}

TEST(PaperIndex, LeavesAirAndConstantsAlone) {
    EXPECT_EQ(paper_index_of(air(), IndexReading::exact), air());
    EXPECT_EQ(paper_index_of(vacuum(), IndexReading::exact), vacuum());
    EXPECT_EQ(paper_index(1.0, 0.5, IndexReading::intended), air());
    const DispersionPtr constant = paper_index(1.5, 0.0, IndexReading::intended);
    EXPECT_TRUE(constant->is_constant());
    EXPECT_EQ(paper_index_of(constant, IndexReading::exact), constant);
}

// κ/f_D = 1.194 in frequency.
TEST(PaperIndex, ExactEndsAtItsPole) {
    EXPECT_GT(linear_index(1.01, 1.18, IndexReading::exact).slope, 0.0);
    EXPECT_THROW(linear_index(1.01, 1.20, IndexReading::exact), InputError);
    EXPECT_NE(message_of(1.01, 5.0, IndexReading::exact).find("below w = 1.19"), std::string::npos);
    EXPECT_EQ(message_of(1.01, 5.0, IndexReading::intended), "");
}

TEST(PaperIndex, RefusesAnIndexThatIsNone) {
    EXPECT_NE(message_of(4.2, 2.0, IndexReading::intended), "");  // 12.6 at the far violet
    EXPECT_NE(message_of(0.5, 0.1, IndexReading::intended), "");
    EXPECT_NE(message_of(NAN, 0.1, IndexReading::intended), "");
    EXPECT_NE(message_of(1.5, NAN, IndexReading::intended), "");
}

TEST(PaperIndex, GoesOnBeyondItsSpectrumAndStaysAMedium) {
    for (const SpectralSpacing spacing : kSpacings) {
        const DispersionPtr n = paper_index(1.5, 0.03, IndexReading::intended, spacing);
        const double slope = linear_index(1.5, 0.03, IndexReading::intended, spacing).slope;
        for (const double nm : {360.0, 830.0}) {
            const double f = paper_coordinate(nm * unit::nm, spacing);
            EXPECT_NEAR(against_air(n, nm * unit::nm), 1.5 + slope * f, kRounding);
        }
    }
    // A line that would fall below 1 at 1100 nm.
    const DispersionPtr steep = paper_index(1.1, 5.0, IndexReading::intended);
    double last = 10.0;
    for (double nm = 300.0; nm < 3000.0; nm += 1.0) {
        const double n = against_air(steep, nm * unit::nm);
        EXPECT_GE(n, 1.0) << nm;
        EXPECT_LE(n, last) << nm;
        last = n;
    }
}

TEST(PaperIndex, OfLanesIsThatOfEach) {
    const DispersionPtr n = paper_index(4.2, 0.5, IndexReading::intended);
    std::vector<double> nm, lanes(19);  // more than a block
    for (int i = 0; i < 19; ++i) nm.push_back(830.0 - 25.3 * i);
    n->eval_lanes(nm, lanes);
    for (std::size_t i = 0; i < nm.size(); ++i)
        EXPECT_EQ(lanes[i], (*n)(nm[i] * unit::nm).value) << nm[i];
}

}  // namespace
}  // namespace dewbow
