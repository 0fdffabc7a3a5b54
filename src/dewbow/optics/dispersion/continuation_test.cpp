// SPDX-License-Identifier: Apache-2.0

// Outside their data formulas go on smoothly, and stay those of a transparent medium.

#include "dewbow/optics/dispersion/continuation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

double index(const DispersionPtr& dispersion, double lambda_nm) {
    return (*dispersion)(lambda_nm * unit::nm).value;
}
DispersionPtr in_vacuum(const std::string& form, const std::vector<double>& c,
                        std::optional<DataRange> range = std::nullopt) {
    return make_dispersion({form, c, IndexReference::vacuum, range});
}

/// From the X-rays that no formula is meant for to where catalogues end.
constexpr double kFrom_nm = 30.0, kTo_nm = 60000.0, kFactor = 1.002;

TEST(Continuation, KeepsEveryGlassAboveOneAndFiniteAtAnyWavelength) {
    for (const Glass& glass : glass_catalogue()) {
        const auto dispersion = make_dispersion(glass.data);
        const double outside_least = glass.name == "fluid/vacuum" ? 1.0 : 1.0 + 1e-9;
        for (double l = kFrom_nm; l < kTo_nm; l *= 1.03) {
            const double n = index(dispersion, l);
            const bool has_data = l >= 0.999 * glass.lambda_min_nm && l <= glass.lambda_max_nm;
            ASSERT_TRUE(std::isfinite(n)) << glass.name << " at " << l;
            if (!has_data) {
                ASSERT_GE(n, outside_least) << glass.name << " at " << l;
            }
        }
    }
}

/// How much the slope of a smooth index changes from one step of 0.2 % to the next: less than 6 %,
/// near resonances and in the infrared; a kink of the continuation would be more.
constexpr double kMostChange = 0.06;

/// The slope in w = 1/λ² is not negative, and has no step.
void expect_smooth_and_falling(const std::string& name, const DispersionPtr& dispersion,
                               double from_nm, double to_nm) {
    const auto w = [](double l) { return 1e6 / (l * l); };
    double slope_before = 0.0;
    for (double l = from_nm; l < to_nm; l *= kFactor) {
        const double next = l * kFactor;
        const double slope = (index(dispersion, l) - index(dispersion, next)) / (w(l) - w(next));
        ASSERT_GE(slope, 0.0) << name << " at " << l;
        if (slope_before > 0.0) {
            ASSERT_NEAR(slope / slope_before, 1.0, kMostChange) << name << " at " << l;
        }
        slope_before = slope;
    }
}

TEST(Continuation, IsSmoothAndMonotoneForGlassesWhoseDataEndInTheVisible) {
    for (const char* name :
         {"schott/SF11", "schott/P-SF68", "gem/diamond", "gem/rutile", "gem/moissanite",
          "crystal/ZnSe", "crystal/SiC-Singh", "fluid/carbon-disulfide", "plastic/polycarbonate",
          "fluid/ethanol", "plastic/PMMA", "hikari/E-F2"})
        expect_smooth_and_falling(name, make_dispersion(find_glass(name).data), 150.0, 1500.0);
}

TEST(Continuation, LeavesAFormulaAloneWhereItBehaves) {
    // SF11 is measured from 390 nm, and its formula is that of a glass down to 360 nm.
    const Glass& sf11 = find_glass("SF11");
    const auto& c = sf11.data.coefficients;
    const double x = 0.36 * 0.36;
    double n2 = 1.0;
    for (std::size_t i = 0; i < c.size(); i += 2) n2 += c[i] * x / (x - c[i + 1]);
    EXPECT_NEAR(index(in_vacuum("sellmeier", c, sf11.data.range), 360.0), std::sqrt(n2), 1e-14);
}

TEST(Continuation, PassesAResonanceAlongATangent) {
    // Zinc selenide is measured from 540 nm; its formula has a resonance at 391 nm.
    const auto znse = make_dispersion(find_glass("ZnSe").data);
    EXPECT_GT(index(znse, 391.0), index(znse, 540.0));
    EXPECT_LT(index(znse, 360.0), 3.7);  // at the resonance itself the formula is infinite
}

TEST(Continuation, ComesNearOneSmoothlyWhereAFormulaFallsBelow) {
    // n² = 2 − 0.4 λ² is below 1 from 1.6 µm on, and has no root from 2.2 µm on.
    const auto handbook = in_vacuum("handbook_1", {2.0, 0.01, 0.01, 0.4});
    expect_smooth_and_falling("handbook_1", handbook, 300.0, 9000.0);
    EXPECT_GT(index(handbook, 5000.0), 1.0);
    // An Abbe number that is none.
    const auto absurd = in_vacuum("abbe", {1.5, 0.4});
    EXPECT_GT(index(absurd, 830.0), 1.0);
    EXPECT_LT(index(absurd, 830.0), 1.05);
    std::vector<double> lambda_nm(8, 5000.0), n(8);
    handbook->eval_lanes(lambda_nm, n);
    for (double v : n) EXPECT_EQ(v, index(handbook, 5000.0));
}

/// The formula of the header, at one point on each side, written again.
TEST(Continuation, IsTheFormulaThatItStates) {
    const auto edge = [](double l) { return 1.2 + 0.1 * (1e6 / (l * l)); };  // slope 0.1 in w
    const auto broken = [&](double l) { return l < 400.0 || l > 800.0 ? std::nan("") : edge(l); };
    const dispersion::Continuation continuation(broken, {500.0, 700.0});
    EXPECT_TRUE(continuation.is_trusted(450.0));
    EXPECT_FALSE(continuation.is_trusted(399.0));
    EXPECT_NEAR(continuation.at(300.0), edge(300.0), 1e-9);  // its tangent is the line itself
    // To the long side n − 1 decays from the last trusted wavelength, within a step of 800 nm.
    const double n = continuation.at(2000.0);
    EXPECT_GT(n, edge(2000.0));
    EXPECT_GT(n, 1.2);
    EXPECT_LT(n, edge(800.0));
}

}  // namespace
}  // namespace dewbow
