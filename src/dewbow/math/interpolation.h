// SPDX-License-Identifier: Apache-2.0
#pragma once

// Linear interpolation in tables.

#include <cstddef>
#include <span>

namespace dewbow {

/// The interval of ascending `abscissae` that holds x: the largest i with abscissae[i] <= x, but at
/// least 0 and at most abscissae.size() - 2, so that i + 1 exists. There are at least two
/// abscissae. Cost: a binary search.
std::size_t interval_of(std::span<const double> abscissae, double x);

/// The polyline through (abscissae[i], values[i]) at x, and its end values beyond its ends. Exact
/// at the abscissae, monotonic between them; NaN for NaN.
/// @param abscissae  strictly ascending, at least one.   @param values  as many.
double interpolate_linear(std::span<const double> abscissae, std::span<const double> values,
                          double x);

/// Where x lies among the knots 0, 1 … knots − 1, at least two: between `first` and first + 1, the
/// share t in [0, 1] of the way. Beyond the ends: at them.
struct KnotInterval {
    int first;
    double t;
};
inline KnotInterval knot_interval(double x, int knots) {
    const double clamped = x > 0.0 ? (x < knots - 1.0 ? x : knots - 1.0) : 0.0;
    const int whole = static_cast<int>(clamped), first = whole < knots - 1 ? whole : knots - 2;
    return {first, clamped - first};
}

/// The same for abscissae `first`, `first + step`, `first + 2 step`…, without a search.
/// @param step  positive.   @param values  at least one.
double interpolate_linear_regular(double first, double step, std::span<const double> values,
                                  double x);

}  // namespace dewbow
