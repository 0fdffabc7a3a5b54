// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/gamma_function.h"

#include <cmath>
#include <limits>

namespace dewbow {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kMostTerms = 10000;

/// x^a e^{−x} / Γ(a), which both expansions share.
double prefactor(double a, double x) { return std::exp(a * std::log(x) - x - std::lgamma(a)); }

double lower_by_series(double a, double x) {
    double term = 1.0 / a, sum = term;
    for (int n = 1; n < kMostTerms && term > kEpsilon * sum; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return prefactor(a, x) * sum;
}

double upper_by_fraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, fraction = d;
    for (int n = 1; n < kMostTerms; ++n) {
        const double numerator = -n * (n - a);
        b += 2.0;
        d = numerator * d + b;
        if (std::abs(d) < kTiny) d = kTiny;
        c = b + numerator / c;
        if (std::abs(c) < kTiny) c = kTiny;
        d = 1.0 / d;
        fraction *= d * c;
        if (std::abs(d * c - 1.0) < kEpsilon) break;
    }
    return prefactor(a, x) * fraction;
}

}  // namespace

double lower_gamma_share(double a, double x) {
    if (x <= 0.0) return 0.0;
    if (std::isinf(x)) return 1.0;
    return x < a + 1.0 ? lower_by_series(a, x) : 1.0 - upper_by_fraction(a, x);
}

double upper_gamma_share(double a, double x) {
    if (x <= 0.0) return 1.0;
    if (std::isinf(x)) return 0.0;
    return x < a + 1.0 ? 1.0 - lower_by_series(a, x) : upper_by_fraction(a, x);
}

}  // namespace dewbow
