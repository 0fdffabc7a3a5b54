// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/math/vector.h"

namespace dewbow {
namespace {

// Nodes are correctly rounded but for the last Newton step.
constexpr double kNodeError = 3e-16;
// Sums of n weights, each good to a few n ulp at the ends; measured 2e-15 up to n = 200.
constexpr double kSumError = 1e-14;

TEST(GaussLegendre, AgreesWithThePublishedTable) {
    // Abramowitz & Stegun 1964, table 25.4.
    const QuadratureRule two = gauss_legendre(2);
    EXPECT_NEAR(two.nodes[1], 0.577350269189626, 1e-15);
    EXPECT_NEAR(two.weights[1], 1.0, 1e-15);
    const QuadratureRule five = gauss_legendre(5);
    EXPECT_EQ(five.nodes[2], 0.0);
    EXPECT_NEAR(five.nodes[3], 0.538469310105683, 1e-15);
    EXPECT_NEAR(five.nodes[4], 0.906179845938664, 1e-15);
    EXPECT_NEAR(five.weights[2], 0.568888888888889, 1e-15);
    EXPECT_NEAR(five.weights[3], 0.478628670499366, 1e-15);
    EXPECT_NEAR(five.weights[4], 0.236926885056189, 1e-15);
    const QuadratureRule many = gauss_legendre(96);
    EXPECT_NEAR(many.nodes[95], 0.999689503883230, 1e-15);
    EXPECT_NEAR(many.weights[95], 0.000796792065552, 1e-15);
}

TEST(GaussLegendre, NodesAscendSymmetricallyAndWeightsSumToTwo) {
    for (const int n : {1, 2, 3, 4, 7, 16, 33, 100, 200, 1000}) {
        const QuadratureRule rule = gauss_legendre(n);
        ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
        double sum = 0.0, before = -1.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            ASSERT_GT(rule.nodes[i], before) << n;
            ASSERT_EQ(rule.nodes[i], -rule.nodes[rule.nodes.size() - 1 - i]);
            before = rule.nodes[i];
            sum += rule.weights[i];
        }
        EXPECT_LT(before, 1.0);
        EXPECT_NEAR(sum, 2.0, 10.0 * kSumError) << n;
    }
}

TEST(GaussLegendre, NodesAreZerosOfThePolynomial) {
    // std::legendre is another implementation. Its slope at the node turns the value into a
    // distance.
    for (const unsigned n : {3u, 10u, 40u, 120u}) {
        const QuadratureRule rule = gauss_legendre(static_cast<int>(n));
        for (const double x : rule.nodes) {
            const double slope =
                n * (std::legendre(n - 1, x) - x * std::legendre(n, x)) / (1.0 - x * x);
            // The reference itself rounds: a few n ulp of its terms.
            EXPECT_NEAR(std::legendre(n, x) / slope, 0.0, kNodeError * 4.0);
        }
    }
}

TEST(GaussLegendre, ExactForPolynomialsOfDegreeTwoNMinusOneAndNotBeyond) {
    for (const int n : {1, 2, 3, 5, 10, 20}) {
        const QuadratureRule rule = gauss_legendre(n);
        for (int degree = 0; degree <= 2 * n; ++degree) {
            const double exact = degree % 2 ? 0.0 : 2.0 / (degree + 1);
            const double found =
                integrate(rule, -1.0, 1.0, [&](double x) { return std::pow(x, degree); });
            if (degree < 2 * n)
                EXPECT_NEAR(found, exact, kSumError) << n << " " << degree;
            else  // the error of degree 2n is known: it shrinks like 4^-n
                EXPECT_GT(std::abs(found - exact), std::pow(4.0, -n)) << n;
        }
    }
}

TEST(Integrate, AnyIntervalAndAnyValue) {
    const QuadratureRule rule = gauss_legendre(20);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(integrate(rule, 0.0, pi, [](double x) { return std::sin(x); }), 2.0, kSumError);
    EXPECT_NEAR(integrate(rule, pi, 0.0, [](double x) { return std::sin(x); }), -2.0, kSumError);
    const Vec3 v = integrate(rule, 0.0, 2.0, [](double x) { return Vec3{1.0, x, x * x}; });
    EXPECT_NEAR(v.x, 2.0, kSumError);
    EXPECT_NEAR(v.y, 2.0, kSumError);
    EXPECT_NEAR(v.z, 8.0 / 3.0, kSumError);
}

}  // namespace
}  // namespace dewbow
