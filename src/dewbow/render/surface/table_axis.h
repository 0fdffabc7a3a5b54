// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewbow {

/// Two neighbours in a table, and the weight of the second.
struct TablePlace {
    std::size_t index;
    double weight;
    double between(double a, double b) const { return a + (b - a) * weight; }
};

/// An axis of `count` >= 2 places alike far from each other, from `first` to `last`.
struct TableAxis {
    double first, last;
    std::size_t count;

    double at(std::size_t i) const {
        return first + (last - first) * double(i) / double(count - 1);
    }
    /// Beyond the ends, the end.
    TablePlace place(double x) const {
        const double steps = double(count - 1);
        const double t = std::clamp((x - first) / (last - first) * steps, 0.0, steps);
        const std::size_t i = std::min(std::size_t(t), count - 2);
        return {i, t - double(i)};
    }
};

/// Numbers from 0 to 1 on an axis that is even below `scale` and logarithmic above:
/// value = scale ((1 + 1 / scale)^x − 1). Shadowing by microfacets of roughness alpha sets in where
/// cos θ ~ alpha.
class LogAxis {
public:
    explicit LogAxis(double scale) : scale_(scale), range_(std::log1p(1.0 / scale)) {}
    double value(double x) const { return std::min(1.0, scale_ * std::expm1(x * range_)); }
    double x(double value) const { return std::log1p(value / scale_) / range_; }
    /// d value / dx at a value.
    double slope(double value) const { return (value + scale_) * range_; }

private:
    double scale_, range_;
};

}  // namespace dewbow
