// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

using Complex = std::complex<double>;
using namespace unit;

/// Of the sum of the terms' moduli.
constexpr double kRounding = 1e-14;

TEST(AngularSum, LowestOrdersHaveClosedForms) {
    // π_1 = 1, π_2 = 3μ, π_3 = (15μ² − 3)/2; τ_1 = μ, τ_2 = 6μ² − 3, τ_3 = (45μ³ − 33μ)/2.
    const Complex a1{0.3, -0.1}, a2{-0.7, 0.2}, a3{0.1, 0.9}, b1{0.5, 0.4}, b2{0.2, -0.8}, b3{1, 1};
    const PartialWaves waves{{a1, a2, a3}, {b1, b2, b3}};
    for (double degrees : {0.0, 1e-6, 10.0, 60.0, 90.0, 90.1, 137.5, 179.99, 180.0}) {
        const Angle theta = degrees * deg;
        Amplitudes S;
        angular_sum({&waves, 1}, {&theta, 1}, {&S, 1});
        const double u = cos(theta);
        const double pi[] = {1.0, 3.0 * u, 7.5 * u * u - 1.5};
        const double tau[] = {u, 6.0 * u * u - 3.0, 22.5 * u * u * u - 16.5 * u};
        Complex s1{}, s2{};
        for (int i = 0; i < 3; ++i) {
            const double c = (2.0 * i + 3.0) / ((i + 1.0) * (i + 2.0));
            s1 += c * (waves.a[i] * pi[i] + waves.b[i] * tau[i]);
            s2 += c * (waves.a[i] * tau[i] + waves.b[i] * pi[i]);
        }
        EXPECT_LT(std::abs(S.perpendicular - s1), 20.0 * kRounding) << degrees;
        EXPECT_LT(std::abs(S.parallel - s2), 20.0 * kRounding) << degrees;
    }
}

}  // namespace
}  // namespace dewbow
