// SPDX-License-Identifier: Apache-2.0
#pragma once

// Welch's t-test of two means, each with a variance of its own, from few values of each.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/math/quadrature.h"

namespace dewbow::kit {

struct MeanOfFew {
    double mean = 0.0, variance_of_mean = 0.0, degrees = 0.0;
};
inline MeanOfFew mean_of(const std::vector<double>& values) {
    const double n = double(values.size());
    MeanOfFew result{0.0, 0.0, n - 1.0};
    for (const double x : values) result.mean += x / n;
    for (const double x : values)
        result.variance_of_mean += (x - result.mean) * (x - result.mean) / (n * (n - 1.0));
    return result;
}

/// The chance that |t| of Student's distribution exceeds `t`. With t = √ν tan θ its density is
/// cos^{ν−1} θ, up to a factor: one integral over another.      [Abramowitz & Stegun 1964, 26.7]
inline double two_sided_chance(double t, double degrees) {
    static const QuadratureRule rule = gauss_legendre(64);
    const auto density = [&](double theta) { return std::pow(std::cos(theta), degrees - 1.0); };
    const double half_pi = 0.5 * std::numbers::pi;
    // Far out all of it lies within a few parts of its first slope.
    const double from = std::atan(std::abs(t) / std::sqrt(degrees));
    const double all = integrate(rule, 0.0, half_pi, density);
    return integrate(rule, from, half_pi, density) / all;
}
/// The t that is exceeded, on either side, with the chance `p`.
inline double two_sided_quantile(double p, double degrees) {
    double low = 0.0, high = 1e3;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (two_sided_chance(middle, degrees) > p ? low : high) = middle;
    }
    return high;
}

struct WelchTest {
    double difference = 0.0;  ///< of the means
    double error = 0.0;       ///< its standard error
    double degrees = 0.0;     ///< [Satterthwaite 1946]
    double chance = 1.0;      ///< of a difference as large, if there is none
    /// A difference that is found at level `alpha` with probability 0.99, about: what t must reach
    /// and how far it falls short once in a hundred times, in standard errors.
    double detectable(double alpha) const {
        return error * (two_sided_quantile(alpha, degrees) + two_sided_quantile(0.02, degrees));
    }
};
inline WelchTest welch(const std::vector<double>& a, const std::vector<double>& b) {
    const MeanOfFew ma = mean_of(a), mb = mean_of(b);
    const double va = ma.variance_of_mean, vb = mb.variance_of_mean, both = va + vb;
    WelchTest test;
    test.difference = ma.mean - mb.mean;
    test.error = std::sqrt(both);
    if (both == 0.0) {  // nothing is left to chance
        test.chance = test.difference == 0.0 ? 1.0 : 0.0;
        test.degrees = ma.degrees;
        return test;
    }
    test.degrees = both * both / (va * va / ma.degrees + vb * vb / mb.degrees);
    test.chance = two_sided_chance(test.difference / test.error, test.degrees);
    return test;
}

}  // namespace dewbow::kit
