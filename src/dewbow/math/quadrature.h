// SPDX-License-Identifier: Apache-2.0
#pragma once

// Integrals of smooth functions by Gauss's rule.

#include <cstddef>
#include <vector>

namespace dewbow {

/// Nodes in ascending order and their weights, for the interval [-1, 1].
struct QuadratureRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

/// The Gauss–Legendre rule with n >= 1 nodes: exact for polynomials of degree 2n - 1.
///
/// The nodes are the zeros of the Legendre polynomial P_n, by Newton's method from
/// cos(pi (4i + 3) / (4n + 2)); the weights are 2 / ((1 - x²) P_n'(x)²).
///                                                    [Abramowitz & Stegun 1964, 25.4.29, 22.16.6]
/// Error, measured to n = 1000: nodes 1e-16, sum of weights 3e-15; a single weight 2e-16 / (1 - x²)
/// relative, so that the outermost and smallest lose digits (4e-14 at n = 96, 2e-11 at n = 1000).
/// Cost: about 8 n² ns, so keep the rule.
QuadratureRule gauss_legendre(int n);

/// The integral of f from a to b by `rule`; `f(x)` gives anything that can be added and multiplied
/// by a double on its left.
template <class Function>
auto integrate(const QuadratureRule& rule, double a, double b, const Function& f) {
    const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
    auto sum = rule.weights[0] * f(centre + half * rule.nodes[0]);
    for (std::size_t i = 1; i < rule.nodes.size(); ++i)
        sum = sum + rule.weights[i] * f(centre + half * rule.nodes[i]);
    return half * sum;
}

}  // namespace dewbow
