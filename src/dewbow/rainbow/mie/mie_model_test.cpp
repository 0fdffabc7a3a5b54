// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/mie_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/math/quadrature.h"
#include "dewbow/rainbow/mie/riccati_bessel.h"
#include "dewbow/rainbow/scattering_matrix.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
using namespace unit;

const ComplexIndex kWater{1.333, 0.0};

std::unique_ptr<ScatteringModel> mie() { return make_scattering_model("mie"); }
const AmplitudeModel& with_phases(const ScatteringModel& model) {
    return dynamic_cast<const AmplitudeModel&>(model);
}

Amplitudes amplitudes_at(const ScatteringModel& model, double x, Angle theta) {
    Amplitudes S;
    with_phases(model).amplitudes(kWater, {x}, {&theta, 1}, {&S, 1});
    return S;
}

// ---- fifty digits: tests/reference/mie_water_50_digits.csv
// -----------------------------------------

double efficiency(const Efficiencies& Q, const std::string& name) {
    if (name == "qext") return Q.extinction;
    return name == "qsca" ? Q.scattering : Q.asymmetry;
}

TEST(MieModel, FiftyDigits) {
    /// Relative, of each amplitude at each angle. Found at x = 10, 100, 1000, 5000, 50000: 6e-15,
    /// 1e-13, 5e-12, 4e-11, 2e-10, of which x · 1e-16 is that 1.333 and the angle are no doubles.
    constexpr double kAmplitude = 1e-9, kEfficiency = 1e-11;
    const auto model = mie();
    std::size_t amplitudes = 0;
    for (const auto& row :
         rows_of_csv(read_file(DEWBOW_SOURCE_DIR "/tests/reference/mie_water_50_digits.csv"),
                     "x,quantity,angle_deg,re,im")) {
        const double x = std::stod(row[0]);
        const Complex expected{std::stod(row[3]), std::stod(row[4])};
        if (row[2].empty()) {
            const double found = efficiency(model->efficiencies(kWater, {x}), row[1]);
            EXPECT_NEAR(found / expected.real(), 1.0, kEfficiency) << row[0] << " " << row[1];
            continue;
        }
        const Amplitudes S = amplitudes_at(*model, x, std::stod(row[2]) * deg);
        const Complex found = row[1] == "S1" ? S.perpendicular : S.parallel;
        EXPECT_LT(std::abs(found - expected), kAmplitude * std::abs(expected))
            << row[0] << " " << row[1] << " at " << row[2] << " deg";
        ++amplitudes;
    }
    EXPECT_EQ(amplitudes, 270u);
}

// ---- laws
// ----------------------------------------------------------------------------------------

TEST(MieModel, EnergyOverTheSphere) {
    // Q_sca = 1/x² ∫ (|S1|² + |S2|²) dμ, and g the mean of μ. The integrand is a polynomial of
    // degree 2N + 1 in μ.
    constexpr double kEnergy = 1e-12;
    for (const ComplexIndex m : {kWater, ComplexIndex{1.5, 0.1}})
        for (double x : {0.001, 1.0, 30.0, 300.0}) {
            const QuadratureRule rule = gauss_legendre(term_count(x) + 3);
            std::vector<Angle> theta;
            for (double u : rule.nodes) theta.insert(theta.begin(), std::acos(u) * rad);
            std::vector<Intensities> I(theta.size());
            const auto model = mie();
            const Drop drop{x};
            model->intensities(m, {&drop, 1}, theta, I);
            double energy = 0.0, momentum = 0.0;
            for (std::size_t i = 0; i < I.size(); ++i) {
                const double part = 2.0 * rule.weights[i] * I[i].unpolarised() / (x * x);
                energy += part;
                momentum += part * cos(theta[i]);
            }
            const Efficiencies Q = model->efficiencies(m, drop);
            EXPECT_NEAR(energy / Q.scattering, 1.0, kEnergy) << x;
            EXPECT_NEAR(momentum / energy, Q.asymmetry, kEnergy) << x;
        }
}

TEST(MieModel, PolarisationOfTheMatrixIsWhole) {
    // S11² = S12² + S33² + S34².                                [Bohren & Huffman 1983, p. 112]
    constexpr double kRounding = 1e-14;
    for (double degrees : {0.0, 30.0, 90.0, 139.0, 180.0}) {
        const Amplitudes S = amplitudes_at(*mie(), 100.0, degrees * deg);
        const ScatteringMatrix M = scattering_matrix(S);
        EXPECT_NEAR((M.S12 * M.S12 + M.S33 * M.S33 + M.S34 * M.S34) / (M.S11 * M.S11), 1.0,
                    kRounding);
        EXPECT_NEAR(M.S11 / (0.5 * (std::norm(S.perpendicular) + std::norm(S.parallel))), 1.0,
                    kRounding);
    }
    // Forward the polarisation stays, backward it is mirrored.
    const ScatteringMatrix forward = scattering_matrix(amplitudes_at(*mie(), 100.0, 0.0 * deg));
    const ScatteringMatrix backward = scattering_matrix(amplitudes_at(*mie(), 100.0, 180.0 * deg));
    EXPECT_NEAR(forward.S33 / forward.S11, 1.0, kRounding);
    EXPECT_NEAR(backward.S33 / backward.S11, -1.0, kRounding);
}

TEST(MieModel, BohrenAndHuffmansSample) {
    // m = 1.55, x = 5.213: S11 over that at 0°, −S12/S11, S33/S11, S34/S11, six digits printed.
    //                                                           [Bohren & Huffman 1983, p. 482]
    constexpr double kPrinted = 1e-6;
    const double rows[][5] = {{9, 0.785390, -0.00459811, 0.999400, 0.0343261},
                              {18, 0.356897, -0.0458541, 0.986022, 0.160184},
                              {27, 0.0766119, -0.364744, 0.843603, 0.394076},
                              {36, 0.0355355, -0.534997, 0.686967, -0.491787},
                              {45, 0.0701845, 0.00959953, 0.959825, -0.280434},
                              {54, 0.0574313, 0.0477927, 0.985371, 0.163584},
                              {63, 0.0219660, -0.440604, 0.648043, 0.621216},
                              {72, 0.0125959, -0.831996, 0.203255, -0.516208},
                              {81, 0.0173750, 0.0341670, 0.795354, -0.605182},
                              {90, 0.0124601, 0.230462, 0.937497, 0.260742}};
    const double x = 2.0 * std::numbers::pi * 0.525 / 0.6328;
    std::vector<Angle> theta{0.0 * deg};
    for (const auto& row : rows) theta.push_back(row[0] * deg);
    std::vector<Amplitudes> S(theta.size());
    with_phases(*mie()).amplitudes({1.55, 0.0}, {x}, theta, S);
    for (std::size_t i = 1; i < S.size(); ++i) {
        const ScatteringMatrix M = scattering_matrix(S[i]);
        const double* expected = rows[i - 1];
        EXPECT_NEAR(M.S11 / scattering_matrix(S[0]).S11, expected[1], kPrinted) << expected[0];
        EXPECT_NEAR(M.degree_of_polarisation(), expected[2], kPrinted) << expected[0];
        EXPECT_NEAR(M.S33 / M.S11, expected[3], kPrinted) << expected[0];
        EXPECT_NEAR(M.S34 / M.S11, expected[4], kPrinted) << expected[0];
    }
}

// ---- many drops together
// -------------------------------------------------------------------------

TEST(MieModel, DropsTogetherAndAloneAgree) {
    // More drops than one group takes, of sizes from small to large, over angles with and without
    // a partner at 180° − θ.
    constexpr double kRounding = 1e-11;
    std::vector<Drop> drops;
    for (int i = 0; i < 37; ++i) drops.push_back({0.002 * std::pow(1.4, i)});
    std::vector<Angle> theta;
    for (int i = 0; i < 90; ++i) theta.push_back(2.0 * i * deg);
    theta.push_back(179.95 * deg);
    std::vector<Intensities> together(drops.size() * theta.size());
    mie()->intensities(kWater, drops, theta, together);
    for (std::size_t d = 0; d < drops.size(); ++d)
        for (std::size_t i = 0; i < theta.size(); ++i) {
            const Amplitudes S = amplitudes_at(*mie(), drops[d].size_parameter, theta[i]);
            const Intensities& I = together[d * theta.size() + i];
            const double scale = std::norm(S.perpendicular) + std::norm(S.parallel);
            ASSERT_NEAR(I.perpendicular, std::norm(S.perpendicular), kRounding * scale)
                << drops[d].size_parameter << " at " << theta[i].to(deg);
            ASSERT_NEAR(I.parallel, std::norm(S.parallel), kRounding * scale);
        }
}

// ---- what is refused
// -----------------------------------------------------------------------------

std::string refusal(ComplexIndex index, const Drop& drop) {
    try {
        mie()->efficiencies(index, drop);
    } catch (const InputError& error) {
        return error.sentence();
    }
    return "";
}

TEST(MieModel, RefusesWhatItCannotTreat) {
    EXPECT_THROW(make_scattering_model("mie", {.orders = {2, 3}, .averaging = {}}), InputError);
    Drop flat{100.0};
    flat.shifts[2] = 0.1 * deg;
    EXPECT_EQ(refusal(kWater, flat), "model \"mie\" is for spheres, and this drop is not one");
    EXPECT_EQ(refusal(kWater, {1e6}),
              "size parameter 1000000 is outside Mie theory's range 0.001 to 50000");
    EXPECT_EQ(refusal({1.333, -0.5}, {10.0}),
              "index 1.333 + -0.5i of a drop: expected a real part above 0 and an imaginary part "
              "(absorption) of 0 or more");
}

}  // namespace
}  // namespace dewbow
