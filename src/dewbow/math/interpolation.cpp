// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/interpolation.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/check.h"

namespace dewbow {

std::size_t interval_of(std::span<const double> abscissae, double x) {
    DEWBOW_CHECK(abscissae.size() >= 2, "an interval has two ends");
    // The first and the last abscissa are left out of the search: beyond them the end intervals
    // count.
    const auto above = std::upper_bound(abscissae.begin() + 1, abscissae.end() - 1, x);
    return static_cast<std::size_t>(above - abscissae.begin()) - 1;
}

double interpolate_linear(std::span<const double> abscissae, std::span<const double> values,
                          double x) {
    DEWBOW_CHECK(!values.empty() && abscissae.size() == values.size(),
                 "a table has one value for each abscissa");
    if (std::isnan(x)) return x;
    if (x <= abscissae.front()) return values.front();
    if (x >= abscissae.back()) return values.back();
    const std::size_t i = interval_of(abscissae, x);
    const double t = (x - abscissae[i]) / (abscissae[i + 1] - abscissae[i]);
    return std::lerp(values[i], values[i + 1], t);
}

double interpolate_linear_regular(double first, double step, std::span<const double> values,
                                  double x) {
    DEWBOW_CHECK(!values.empty(), "a table has a value");
    if (std::isnan(x)) return x;
    const double last = static_cast<double>(values.size() - 1);
    const double position = (x - first) / step;
    if (!(position > 0.0)) return values.front();
    if (position >= last) return values.back();
    const double below = std::floor(position);
    const auto i = static_cast<std::size_t>(below);
    return std::lerp(values[i], values[i + 1], position - below);
}

}  // namespace dewbow
