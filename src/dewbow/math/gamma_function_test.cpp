// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/gamma_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewbow {
namespace {

/// Rounding of exponents up to 100 in the prefactor, with a reserve.
constexpr double kError = 1e-13;

TEST(GammaShare, OfWholeNumbersIsAPoissonSum) {
    // Q(n, x) = e^{−x} Σ_{k<n} x^k / k!                       [Abramowitz & Stegun 1964, 6.5.13]
    for (const int n : {1, 2, 3, 7, 20, 60})
        for (const double x : {1e-3, 0.5, 1.0, 3.0, 8.0, 20.0, 61.0, 90.0}) {
            double term = std::exp(-x), sum = 0.0;
            for (int k = 0; k < n; ++k) {
                sum += term;
                term *= x / (k + 1);
            }
            EXPECT_NEAR(upper_gamma_share(n, x), sum, kError) << n << " " << x;
            EXPECT_NEAR(lower_gamma_share(n, x), 1.0 - sum, kError) << n << " " << x;
        }
}

TEST(GammaShare, OfOneHalfIsTheErrorFunction) {
    for (const double x : {1e-6, 0.1, 1.0, 1.4, 1.6, 5.0, 30.0}) {
        EXPECT_NEAR(lower_gamma_share(0.5, x), std::erf(std::sqrt(x)), kError);
        // Small tails keep their digits.
        EXPECT_NEAR(upper_gamma_share(0.5, x) / std::erfc(std::sqrt(x)), 1.0, kError);
    }
}

TEST(GammaShare, KnowsItsEnds) {
    EXPECT_EQ(lower_gamma_share(2.5, 0.0), 0.0);
    EXPECT_EQ(upper_gamma_share(2.5, 0.0), 1.0);
    EXPECT_EQ(lower_gamma_share(2.5, std::numeric_limits<double>::infinity()), 1.0);
    EXPECT_EQ(upper_gamma_share(2.5, std::numeric_limits<double>::infinity()), 0.0);
}

}  // namespace
}  // namespace dewbow
