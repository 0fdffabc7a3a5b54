// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/spherical_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewbow {
namespace {

TEST(LegendreHarmonics, AreTheStandardLibrarysWithTheirFactor) {
    constexpr int kDegree = 8;
    constexpr double kRounding = 1e-13;
    std::vector<double> out(harmonic_count(kDegree));
    for (const double mu : {-1.0, -0.7, 0.0, 0.02, 0.9, 1.0}) {
        legendre_harmonics(kDegree, mu, out);
        for (int m = 0; m <= kDegree; ++m)
            for (int l = m; l <= kDegree; ++l) {
                const double factor =
                    std::sqrt(std::tgamma(l - m + 1.0) / std::tgamma(l + m + 1.0));
                EXPECT_NEAR(out[harmonic_index(kDegree, m, l)],
                            factor * std::assoc_legendre(l, m, mu), kRounding)
                    << l << " " << m << " " << mu;
            }
    }
}

TEST(LegendreHarmonics, AddUpToThePolynomialOfTheAngleBetween) {
    constexpr int kDegree = 32;
    constexpr double kRounding = 1e-13;
    std::vector<double> a(harmonic_count(kDegree)), b(a.size());
    const double mu = 0.3, nu = -0.85, phi = 1.1;
    legendre_harmonics(kDegree, mu, a);
    legendre_harmonics(kDegree, nu, b);
    const double cosine = mu * nu + std::sqrt((1.0 - mu * mu) * (1.0 - nu * nu)) * std::cos(phi);
    for (int l = 0; l <= kDegree; ++l) {
        double sum = 0.0;
        for (int m = 0; m <= l; ++m) {
            const std::size_t at = harmonic_index(kDegree, m, l);
            sum += (m == 0 ? 1.0 : 2.0) * a[at] * b[at] * std::cos(m * phi);
        }
        EXPECT_NEAR(sum, std::legendre(l, cosine), kRounding) << l;
    }
}

}  // namespace
}  // namespace dewbow
