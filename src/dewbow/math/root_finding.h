// SPDX-License-Identifier: Apache-2.0
#pragma once

// Zeros of functions of one variable.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dewbow {

/// A zero of `f` between a and b, to within `tolerance` (or the spacing of doubles, if that is
/// larger). Nothing if f has the same sign at both ends, is NaN somewhere, or an end is not finite.
/// A jump through zero counts as a zero.
///
/// Inverse quadratic interpolation where the last three points are near enough to a monotonic
/// curve, else bisection: it always ends, and on smooth functions takes about as few calls as
/// Brent's method. [Chandrupatla, "A new hybrid quadratic/bisection algorithm", Advances in
/// Engineering Software 28(3) 1997]
template <class Function>
std::optional<double> find_root(const Function& f, double a, double b, double tolerance = 0.0) {
    // Never reached: bisection alone ends after 2100 halvings of the widest interval of doubles,
    // and this method takes at most a few times as many as it would.
    constexpr int kMostSteps = 10000;
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

    if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
    // (x1, f1) is the newest point, the zero lies between it and (x2, f2), and (x3, f3) is the
    // point before.
    double x1 = b, f1 = f(b), x2 = a, f2 = f(a);
    if (f1 == 0.0) return x1;
    if (f2 == 0.0) return x2;
    if (!(f1 > 0.0 ? f2 < 0.0 : f1 < 0.0 && f2 > 0.0)) return std::nullopt;

    double t = 0.5;
    for (int step = 0; step < kMostSteps; ++step) {
        const double x = x1 + t * (x2 - x1), value = f(x);
        if (std::isnan(value)) return std::nullopt;
        const bool same_side = (value > 0.0) == (f1 > 0.0);
        const double x3 = same_side ? x1 : x2, f3 = same_side ? f1 : f2;
        if (!same_side) x2 = x1, f2 = f1;
        x1 = x, f1 = value;

        const double best = std::abs(f1) < std::abs(f2) ? x1 : x2;
        if (f1 == 0.0) return x1;
        // The closest that two steps may come, as a part of the bracket.
        const double margin = (2.0 * kEpsilon * std::abs(best) + 0.5 * tolerance +
                               std::numeric_limits<double>::min()) /
                              std::abs(x2 - x1);
        if (margin >= 0.5) return best;

        const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
        const bool monotonic = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        t = monotonic ? f1 / (f2 - f1) * f3 / (f2 - f3) +
                            (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
                      : 0.5;
        t = std::clamp(t, margin, 1.0 - margin);
    }
    return std::nullopt;
}

}  // namespace dewbow
