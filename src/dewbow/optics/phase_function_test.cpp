// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/phase_function.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

/// What 96 nodes of Gauss's rule leave of the peak at |g| = 0.8.
constexpr double kQuadrature = 1e-12;

double at(const PhaseFunction& phase, double cosine) {
    const std::array<double, 2> lambda_nm{450.0, 650.0};
    std::array<double, 2> p;
    phase.eval_lanes(cosine, lambda_nm, p);
    EXPECT_EQ(p[0], p[1]);
    return p[0];
}

/// ∫ p(μ) P(μ) dω over the sphere, of a polynomial P.
template <class Polynomial>
double moment(double g, Polynomial&& polynomial) {
    const PhaseFunctionPtr phase = henyey_greenstein(g);
    return integrate(gauss_legendre(96), -1.0, 1.0, [&](double mu) {
        return 2.0 * std::numbers::pi * at(*phase, mu) * polynomial(mu);
    });
}

// Its expansion in Legendre's polynomials has the coefficients gⁿ. [Henyey & Greenstein 1941]
TEST(HenyeyGreenstein, HasTheMomentsOfPowersOfG) {
    for (const double g : {-0.8, -0.3, 0.0, 0.5, 0.8}) {
        EXPECT_NEAR(moment(g, [](double) { return 1.0; }), 1.0, kQuadrature) << g;
        EXPECT_NEAR(moment(g, [](double mu) { return mu; }), g, kQuadrature) << g;
        EXPECT_NEAR(moment(g, [](double mu) { return 1.5 * mu * mu - 0.5; }), g * g, kQuadrature)
            << g;
    }
}

TEST(HenyeyGreenstein, IsAllWaysAlikeAtZero) {
    for (const double mu : {-1.0, 0.2, 1.0})
        EXPECT_NEAR(at(*henyey_greenstein(0.0), mu), 0.25 / std::numbers::pi, 1e-16);
}

// (1 + g) / (4π (1 − g)²) forward and (1 − g) / (4π (1 + g)²) back, where g is all but 1 too.
TEST(HenyeyGreenstein, HasItsEnds) {
    for (const double g : {-0.9, 0.4, 0.999999}) {
        const double forward = 0.25 / std::numbers::pi * (1.0 + g) / ((1.0 - g) * (1.0 - g));
        const double back = 0.25 / std::numbers::pi * (1.0 - g) / ((1.0 + g) * (1.0 + g));
        EXPECT_NEAR(at(*henyey_greenstein(g), 1.0) / forward, 1.0, 1e-13) << g;
        EXPECT_NEAR(at(*henyey_greenstein(g), -1.0) / back, 1.0, 1e-13) << g;
    }
}

}  // namespace
}  // namespace dewbow
