// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/absorption_band.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/optics/dispersion.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-14;

TEST(AbsorptionBand, WithoutDampingIsSellmeiers) {
    const DispersionPtr sellmeier =
        make_dispersion({"sellmeier", {1.25, 0.01}, IndexReference::vacuum});
    for (const Wavelength lambda : {400.0 * unit::nm, 550.0 * unit::nm, 800.0 * unit::nm}) {
        const std::complex<double> n = index_near({1.25, 100.0 * unit::nm, 0.0}, lambda);
        EXPECT_NEAR(n.real(), (*sellmeier)(lambda).value, kRounding);
        EXPECT_EQ(n.imag(), 0.0);
    }
}

TEST(AbsorptionBand, FallsThroughTheBandAndRisesElsewhere) {
    const AbsorptionBand band{0.2, 300.0 * unit::nm, 0.1};
    const auto slope = [&](double x) {  // over the frequency
        constexpr double kStep = 1e-5;
        return index_near(band, band.c / (x + kStep)).real() -
               index_near(band, band.c / (x - kStep)).real();
    };
    for (const double x : {0.3, 0.7, 0.9, 1.3, 2.0}) EXPECT_GT(slope(x), 0.0) << x;
    for (const double x : {0.98, 1.0, 1.03}) EXPECT_LT(slope(x), 0.0) << x;
    for (const double x : {0.3, 1.0, 2.0}) EXPECT_GT(index_near(band, band.c / x).imag(), 0.0);
}

// ∫ Im ε(x) x dx over all frequencies is π b / 2, whatever the damping.  [Thomas–Reiche–Kuhn sum]
TEST(AbsorptionBand, AbsorbsByItsStrength) {
    constexpr double kStep = 1e-3, kMost = 400.0;
    for (const double damping : {0.05, 0.3}) {
        const AbsorptionBand band{0.7, 300.0 * unit::nm, damping};
        double sum = 0.0;
        for (double x = 0.5 * kStep; x < kMost; x += kStep) {
            const std::complex<double> n = index_near(band, band.c / x);
            sum += (n * n).imag() * x * kStep;
        }
        const double beyond = 0.7 * damping / kMost;  // ∫ b γ/x² dx
        EXPECT_NEAR(sum + beyond, 0.5 * std::numbers::pi * 0.7, 1e-5) << damping;
    }
}

}  // namespace
}  // namespace dewbow
