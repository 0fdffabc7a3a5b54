// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/partial_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/rainbow/embedded_data.h"
#include "dewbow/rainbow/mie/angular_sum.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
using Columns = std::vector<std::vector<double>>;
using namespace unit;

/// Of two quantities, relative to the second one's modulus.
void expect_close(Complex found, Complex expected, double tolerance, const std::string& what) {
    EXPECT_LE(std::abs(found - expected), tolerance * std::abs(expected))
        << what << ": " << found << " for " << expected;
}

Amplitudes amplitudes_at(const PartialWaves& waves, Angle theta) {
    Amplitudes S;
    angular_sum({&waves, 1}, {&theta, 1}, {&S, 1});
    return S;
}

// ---- MIEV0's own cases, data/drops
// ---------------------------------------------------------------

/// Where MIEV0 stops its sums, earlier than we do: that alone changes the backward amplitude of
/// case 11 by 4e-6, and S2 of case 2 at 60 deg by 8e-5.      [Wiscombe 1980, Appl. Opt. 19, 1505,
/// p. 1508]
std::size_t terms_of_miev0(double x) {
    if (x <= 8.0) return std::size_t(x + 4.0 * std::cbrt(x) + 1.0);
    return std::size_t(x + (x < 4200.0 ? 4.05 : 4.0) * std::cbrt(x) + 2.0);
}

PartialWaves waves_of_case(const Columns& cases, std::size_t row) {
    const double x = cases[1][row];
    PartialWaves waves =
        cases[4][row] == 1.0 ? conductor_waves(x) : mie_waves({cases[2][row], -cases[3][row]}, x);
    waves.a.resize(terms_of_miev0(x));
    waves.b.resize(terms_of_miev0(x));
    return waves;
}

/// Seven digits are printed; a series for small particles served three of the cases.
double tolerance_of_case(double number) {
    constexpr double kPrinted = 1e-6, kSmallConductor = 1e-2, kSmallParticle = 1e-5;
    if (number == 1.0) return kSmallConductor;
    return number == 5.0 || number == 12.0 ? kSmallParticle : kPrinted;
}

TEST(MieWaves, EfficienciesOfMiev0) {
    const Columns cases = columns_of_csv(rainbow::data::miev0_cases_csv());
    ASSERT_EQ(cases[0].size(), 19u);
    for (std::size_t i = 0; i < cases[0].size(); ++i) {
        const PartialWaves waves = waves_of_case(cases, i);
        const Efficiencies Q = efficiencies_of(waves, cases[1][i]);
        const double tolerance = tolerance_of_case(cases[0][i]);
        const std::string name = "case " + std::to_string(i + 1);
        expect_close(Q.extinction, cases[5][i], tolerance, name);
        expect_close(Q.scattering, cases[6][i], tolerance, name);
        expect_close(Q.scattering * Q.asymmetry, cases[7][i], tolerance, name);
        // MIEV0's amplitudes are the conjugates.
        expect_close(amplitudes_at(waves, 0.0 * deg).perpendicular, {cases[8][i], -cases[9][i]},
                     tolerance, name);
        expect_close(amplitudes_at(waves, 180.0 * deg).perpendicular, {cases[10][i], -cases[11][i]},
                     tolerance, name);
    }
}

TEST(MieWaves, AmplitudesOfMiev0) {
    const Columns cases = columns_of_csv(rainbow::data::miev0_cases_csv());
    const Columns rows = columns_of_csv(rainbow::data::miev0_amplitudes_csv());
    ASSERT_EQ(rows[0].size(), 19u * 7u);
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
        const PartialWaves waves = waves_of_case(cases, std::size_t(rows[0][i]) - 1);
        const Amplitudes S = amplitudes_at(waves, rows[1][i] * deg);
        const double tolerance = tolerance_of_case(rows[0][i]);
        const std::string name = "case " + std::to_string(int(rows[0][i])) + " at " +
                                 std::to_string(int(rows[1][i])) + " deg";
        expect_close(S.perpendicular, {rows[2][i], -rows[3][i]}, tolerance, name + ", S1");
        expect_close(S.parallel, {rows[4][i], -rows[5][i]}, tolerance, name + ", S2");
    }
}

// ---- fifty digits: tests/reference/mie_indices_50_digits.csv
// ----------------------------------------

PartialWaves waves_of_row(const std::vector<std::string>& row) {
    const double x = std::stod(row[0]), n = std::stod(row[1]);
    return std::isinf(n) ? conductor_waves(x) : mie_waves({n, std::stod(row[2])}, x);
}

TEST(MieWaves, FiftyDigitsAtManyIndices) {
    // Found: efficiencies 9e-16, g 3e-15, amplitudes 1e-12 of the greater one at the angle, of x =
    // 3000.
    constexpr double kEfficiency = 1e-14, kAsymmetry = 1e-13, kAmplitude = 1e-11;
    std::size_t amplitudes = 0;
    for (const auto& row :
         rows_of_csv(read_file(DEWBOW_SOURCE_DIR "/tests/reference/mie_indices_50_digits.csv"),
                     "x,n,k,quantity,angle_deg,re,im")) {
        const std::string name = row[0] + ", " + row[1] + " + " + row[2] + "i: " + row[3];
        const PartialWaves waves = waves_of_row(row);
        const Efficiencies Q = efficiencies_of(waves, std::stod(row[0]));
        const Complex expected{std::stod(row[5]), std::stod(row[6])};
        if (row[3] == "qext") expect_close(Q.extinction, expected, kEfficiency, name);
        if (row[3] == "qsca") expect_close(Q.scattering, expected, kEfficiency, name);
        if (row[3] == "g") expect_close(Q.asymmetry, expected, kAsymmetry, name);
        if (row[4].empty()) continue;
        const Amplitudes S = amplitudes_at(waves, std::stod(row[4]) * deg);
        const double local = std::max(std::abs(S.perpendicular), std::abs(S.parallel));
        const Complex found = row[3] == "S1" ? S.perpendicular : S.parallel;
        EXPECT_LE(std::abs(found - expected), kAmplitude * local) << name << " at " << row[4];
        ++amplitudes;
    }
    EXPECT_EQ(amplitudes, 16u * 12u);
}

// ---- other published numbers
// ---------------------------------------------------------------------

TEST(MieWaves, BohrenAndHuffmansTable41) {
    // x = 3, m = 1.33 + 1e-8 i, five digits printed.                [Bohren & Huffman 1983, p. 114]
    constexpr double kPrinted = 0.6e-5;
    const PartialWaves waves = mie_waves({1.33, 1e-8}, 3.0);
    const Complex a[] = {{0.51631, -0.49973}, {0.34192, -0.47435}, {0.048467, -0.21475}};
    const Complex b[] = {{0.73767, -0.43990}, {0.40079, -0.49006}, {0.0093553, -0.096269}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(waves.a[i] - a[i]), 2.0 * kPrinted) << i;
        EXPECT_LT(std::abs(waves.b[i] - b[i]), 2.0 * kPrinted) << i;
    }
}

TEST(MieWaves, BohrenAndHuffmansSample) {
    // m = 1.55, radius 0.525 µm, 0.6328 µm.                         [Bohren & Huffman 1983, p. 482]
    constexpr double kPrinted = 1e-5;
    const double x = 2.0 * std::numbers::pi * 0.525 / 0.6328;
    const PartialWaves waves = mie_waves({1.55, 0.0}, x);
    const Efficiencies Q = efficiencies_of(waves, x);
    EXPECT_NEAR(Q.extinction, 3.10543, kPrinted);
    EXPECT_NEAR(Q.scattering, 3.10543, kPrinted);
    EXPECT_NEAR(Q.asymmetry, 0.63314, kPrinted);
    EXPECT_NEAR(backscatter_efficiency(waves, x), 2.92534, kPrinted);
}

// ---- laws
// ----------------------------------------------------------------------------------------

TEST(MieWaves, OpticalTheorem) {
    // Q_ext = 4/x² Re S(0).                                     [Bohren & Huffman 1983, eq. 4.76]
    constexpr double kRounding = 1e-12;
    for (const ComplexIndex m : {ComplexIndex{1.333, 0.0}, {0.75, 0.0}, {1.5, 1.0}, {1.33, 1e-9}})
        for (double x : {1e-3, 0.1, 3.0, 200.0, 20000.0}) {
            const PartialWaves waves = mie_waves(m, x);
            const Complex S = amplitudes_at(waves, 0.0 * deg).perpendicular;
            expect_close(4.0 / (x * x) * S.real(), efficiencies_of(waves, x).extinction, kRounding,
                         "x = " + std::to_string(x));
        }
}

TEST(MieWaves, BackwardSumIsTheAmplitudeThere) {
    constexpr double kRounding = 1e-10;
    for (double x : {0.5, 50.0, 3000.0}) {
        const PartialWaves waves = mie_waves({1.333, 0.0}, x);
        const Complex S = amplitudes_at(waves, 180.0 * deg).parallel;
        expect_close(4.0 * std::norm(S) / (x * x), backscatter_efficiency(waves, x), kRounding,
                     "x = " + std::to_string(x));
    }
}

TEST(MieWaves, SmallestSpheresAreRayleighs) {
    // With L = (m² − 1)/(m² + 2): Q_sca = 8/3 x⁴ |L|² (1 + 6/5 x² Re((m² − 2)/(m² + 2)) …) without
    // absorption, Q_abs = 4x Im(L (1 + x²/15 L (m⁴ + 27m² + 38)/(2m² + 3))).
    //                                                             [van de Hulst 1957, §10.3,
    //                                                             §14.21]
    constexpr double kNextOrder = 1e-11;  // x⁴ = 1e-12 at x = 1e-3
    const double x = kSmallestSize;
    for (double n : {0.75, 1.0001, 1.333, 10.0}) {
        const double m2 = n * n, L = (m2 - 1.0) / (m2 + 2.0);
        const double expected =
            8.0 / 3.0 * std::pow(x, 4) * L * L * (1.0 + 1.2 * x * x * (m2 - 2.0) / (m2 + 2.0));
        const Efficiencies Q = efficiencies_of(mie_waves({n, 0.0}, x), x);
        EXPECT_NEAR(Q.scattering / expected, 1.0, n == 10.0 ? 1e-7 : kNextOrder) << n;
        EXPECT_NEAR(Q.extinction / Q.scattering, 1.0, 1e-14) << n;
    }
    for (const ComplexIndex m : {ComplexIndex{1.333, 1e-9}, {1.33, 0.1}, {1.5, 1.0}}) {
        const Complex m2 = m.value() * m.value(), L = (m2 - 1.0) / (m2 + 2.0);
        const Complex series =
            L * (1.0 + x * x / 15.0 * L * (m2 * m2 + 27.0 * m2 + 38.0) / (2.0 * m2 + 3.0));
        const Efficiencies Q = efficiencies_of(mie_waves(m, x), x);
        const double scattering = 8.0 / 3.0 * std::pow(x, 4) * std::norm(L);
        const double absorption = 4.0 * x * series.imag();
        EXPECT_NEAR(Q.scattering / scattering, 1.0, 3.0 * x * x);
        // x³ times |L|² of what is scattered belongs to the next order.
        EXPECT_NEAR((Q.extinction - Q.scattering) / absorption, 1.0, 4.0 * x * x * x) << m.k;
    }
}

TEST(MieWaves, AbsorptionIsOnlyWhereTheIndexIsComplex) {
    // Each wave of a sphere that absorbs nothing lies on the circle Re a = |a|²; with absorption
    // inside it.                                                  [van de Hulst 1957, §9.32]
    for (double x : {0.01, 10.0, 5000.0}) {
        const PartialWaves clear = mie_waves({1.333, 0.0}, x), grey = mie_waves({1.333, 1e-4}, x);
        for (std::size_t i = 0; i < clear.a.size(); ++i) {
            EXPECT_NEAR(clear.a[i].real(), std::norm(clear.a[i]), 1e-15 * clear.a[i].real());
            EXPECT_NEAR(clear.b[i].real(), std::norm(clear.b[i]), 1e-15 * clear.b[i].real());
            EXPECT_GT(grey.a[i].real(), std::norm(grey.a[i]));
            EXPECT_GT(grey.b[i].real(), std::norm(grey.b[i]));
        }
    }
}

TEST(MieWaves, IndexOneScattersNothing) {
    const Efficiencies Q = efficiencies_of(mie_waves({1.0, 0.0}, 20.0), 20.0);
    EXPECT_LT(Q.scattering, 1e-25);
}

TEST(MieWaves, RealAndComplexIndicesMeet) {
    constexpr double kTiny = 1e-17, kRounding = 1e-9;
    for (double x : {0.01, 10.0, 1000.0}) {
        const PartialWaves real = mie_waves({1.333, 0.0}, x),
                           complex = mie_waves({1.333, kTiny}, x);
        for (std::size_t i = 0; i < real.a.size(); ++i) {
            EXPECT_LT(std::abs(real.a[i] - complex.a[i]), kRounding * std::abs(real.a[i])) << i;
            EXPECT_LT(std::abs(real.b[i] - complex.b[i]), kRounding * std::abs(real.b[i])) << i;
        }
    }
}

TEST(MieWaves, GreatIndicesTendToThePerfectConductor) {
    // Differences fall as 1/|m|.
    constexpr double kIndex = 1e5, kConductor = 30.0 / kIndex;
    for (double x : {0.1, 3.0, 30.0}) {
        const Efficiencies metal = efficiencies_of(mie_waves({kIndex, kIndex}, x), x);
        const Efficiencies conductor = efficiencies_of(conductor_waves(x), x);
        EXPECT_NEAR(metal.scattering / conductor.scattering, 1.0, kConductor) << x;
        EXPECT_NEAR(metal.asymmetry, conductor.asymmetry, kConductor) << x;
    }
}

// ---- what is refused
// ------------------------------------------------------------------------------

TEST(MieWaves, RefusesWhatItCannotTreat) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (double x : {0.0, -1.0, 9.9e-4, 50001.0, kNaN, kInfinity}) {
        EXPECT_THROW(mie_waves({1.333, 0.0}, x), InputError) << x;
        EXPECT_THROW(conductor_waves(x), InputError) << x;
    }
    for (const ComplexIndex m : {ComplexIndex{0.0, 0.0},
                                 {-1.0, 0.0},
                                 {kNaN, 0.0},
                                 {kInfinity, 0.0},
                                 {1.5, -1e-9},
                                 {1.5, kNaN},
                                 {1.5, kInfinity},
                                 {1e7, 1e7}})
        EXPECT_THROW(mie_waves(m, 10.0), InputError) << m.n << " " << m.k;
}

}  // namespace
}  // namespace dewbow
