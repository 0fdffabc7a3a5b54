// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/riccati_bessel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewbow {
namespace {

using Complex = std::complex<double>;

/// Rounding, with a reserve for a few terms.
constexpr double kRounding = 1e-14;
/// What libstdc++'s spherical Bessel functions are good for at x <= 200, beside closed forms.
constexpr double kLibrary = 1e-10;

TEST(RiccatiBessel, LowestOrdersHaveClosedForms) {
    for (double x : {1e-3, 0.3, 1.0, 7.7, 22.0 / 7.0, 1000.0, 50000.0}) {
        const RiccatiBessel waves = riccati_bessel(x, term_count(x));
        const double s = std::sin(x), c = std::cos(x);
        EXPECT_NEAR(waves.psi[0], s, kRounding * std::max(1.0, std::sqrt(x))) << x;
        EXPECT_EQ(waves.chi[0], c);
        EXPECT_NEAR(waves.chi[1], c / x + s, kRounding * std::max(1.0, 1.0 / x));
        // ψ_1 = sin x / x − cos x cancels at small x: its series there.
        const double psi_1 = x < 0.1 ? x * x / 3.0 * (1.0 - x * x / 10.0) : s / x - c;
        EXPECT_NEAR(waves.psi[1], psi_1, kRounding * std::max(psi_1, std::sqrt(x))) << x;
    }
}

TEST(RiccatiBessel, AgreesWithTheLibrarysSphericalBesselFunctions) {
    for (double x : {0.05, 1.0, 10.0, 200.0}) {
        const int N = term_count(x);
        const RiccatiBessel waves = riccati_bessel(x, N);
        for (int n = 0; n <= N; ++n) {
            const double psi = x * std::sph_bessel(unsigned(n), x);
            const double chi = -x * std::sph_neumann(unsigned(n), x);
            EXPECT_NEAR(waves.psi[n], psi, kLibrary * std::min(1.0, std::abs(1.0 / chi))) << n;
            EXPECT_NEAR(waves.chi[n], chi, kLibrary * std::max(1.0, std::abs(chi))) << n;
        }
    }
}

TEST(RiccatiBessel, DerivativesOfOutgoingWavesKeepTheWronskian) {
    // ξ_0 = −i e^{ix}, so ξ_0'/ξ_0 = i; and (ξ'/ξ)' = n(n+1)/x² − 1 − (ξ'/ξ)², by differences.
    constexpr double kStep = 1e-5, kDifference = 1e-8;
    /// Rounding of imaginary parts that hardly change with x, over the step.
    constexpr double kOscillating = 1e-3, kEvanescent = 1e-6;
    const double x = 30.0;
    const int N = term_count(x);
    const auto at = [&](double y) { return outgoing_derivatives(y, riccati_bessel(y, N)); };
    const std::vector<Complex> before = at(x - kStep), here = at(x), after = at(x + kStep);
    EXPECT_NEAR(std::abs(here[0] - Complex{0.0, 1.0}), 0.0, kRounding);
    for (int n = 1; n <= N; ++n) {
        const Complex slope = (after[n] - before[n]) / (2.0 * kStep);
        const Complex equation = n * (n + 1.0) / (x * x) - 1.0 - here[n] * here[n];
        EXPECT_NEAR(slope.real(), equation.real(), kDifference) << n;
        EXPECT_NEAR(slope.imag() / equation.imag(), 1.0, n < x ? kOscillating : kEvanescent) << n;
    }
}

TEST(LogarithmicDerivatives, LowestOrdersHaveClosedForms) {
    for (const Complex z : {Complex{0.5, 0.0}, {3.0, 1.0}, {100.0, 0.01}, {60.0, 60.0}}) {
        const std::vector<Complex> D = logarithmic_derivatives(z, 3);
        const Complex psi_0 = std::sin(z), psi_1 = psi_0 / z - std::cos(z);
        EXPECT_LT(std::abs(D[0] - std::cos(z) / psi_0), kRounding * std::abs(z) * std::abs(D[0]));
        EXPECT_LT(std::abs(D[1] - (psi_0 / psi_1 - 1.0 / z)),
                  10.0 * kRounding * std::abs(z) * std::abs(D[1]));
    }
}

TEST(LogarithmicDerivatives, RealAndComplexAgree) {
    for (double z : {1e-3, 1.0, 133.3, 5000.0}) {
        const std::vector<double> real = logarithmic_derivatives(z, 200);
        const std::vector<Complex> complex = logarithmic_derivatives(Complex{z, 0.0}, 200);
        for (int n = 0; n <= 200; ++n) {
            EXPECT_NEAR(complex[n].real() / real[n], 1.0, 1e-10) << z << " " << n;
            EXPECT_EQ(complex[n].imag(), 0.0);
        }
    }
}

TEST(PsiRatios, KeepTheirDigitsNearZero) {
    // ψ_n / ψ_{n−1} = z / (2n+1) · (1 + z² / ((2n+1)(2n+3)) + …).
    const double z = 1e-3;
    const std::vector<double> ratios = psi_ratios(z, 5);
    for (int n = 1; n <= 5; ++n) {
        const double k = 2.0 * n + 1.0;
        EXPECT_NEAR(ratios[n] / (z / k * (1.0 + z * z / (k * (k + 2.0)))), 1.0, kRounding);
    }
}

}  // namespace
}  // namespace dewbow
