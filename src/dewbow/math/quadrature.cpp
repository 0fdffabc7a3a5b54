// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/quadrature.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/check.h"

namespace dewbow {

namespace {

// Newton's method doubles the digits; the start has three or more of them.
constexpr int kMostNewtonSteps = 8;

struct Legendre {
    double value;
    double derivative;
};

/// P_n and P_n' at x, |x| < 1, by the three-term recurrence. [Abramowitz & Stegun
/// 1964, 22.7.10, 22.8.5]
Legendre legendre(int n, double x) {
    double before = 1.0, value = x;
    for (int k = 2; k <= n; ++k) {
        // P_k = x P_(k-1) + (k-1)/k (x P_(k-1) - P_(k-2)): the form that rounds least.
        const double product = x * value;
        const double next = product + (product - before) * (static_cast<double>(k - 1) / k);
        before = value;
        value = next;
    }
    return {value, n * (before - x * value) / ((1.0 - x) * (1.0 + x))};
}

/// The zero of P_n near `x`.
double refine(int n, double x) {
    for (int step = 0; step < kMostNewtonSteps; ++step) {
        const Legendre p = legendre(n, x);
        const double change = p.value / p.derivative;
        x -= change;
        if (std::abs(change) <= std::numeric_limits<double>::epsilon() * std::abs(x)) break;
    }
    return x;
}

}  // namespace

QuadratureRule gauss_legendre(int n) {
    DEWBOW_CHECK(n >= 1, "a quadrature rule has a node");
    const auto size = static_cast<std::size_t>(n);
    QuadratureRule rule{std::vector<double>(size), std::vector<double>(size)};
    for (std::size_t i = 0; 2 * i < size; ++i) {
        const std::size_t mirrored = size - 1 - i;
        const double guess =
            std::cos(std::numbers::pi * (4.0 * static_cast<double>(i) + 3.0) / (4.0 * n + 2.0));
        const double x = i == mirrored ? 0.0 : refine(n, guess);
        const double slope = legendre(n, x).derivative;
        rule.nodes[i] = -x;
        rule.nodes[mirrored] = x;
        rule.weights[i] = rule.weights[mirrored] = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
    }
    return rule;
}

}  // namespace dewbow
