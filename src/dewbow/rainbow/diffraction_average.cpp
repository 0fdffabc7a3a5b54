// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/diffraction_average.h"

#include <math.h>  // j1 is POSIX's; the standard's Bessel functions are twenty times slower

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

/// Steps in x s of the largest drop: the fringes are π long.
constexpr double kStep = 0.2;
/// Beyond it drops of one size have their mean over fringes as well: x s, the 60th dark ring.
constexpr double kLast = 190.0;
constexpr double kWashedOut = 1e-3;
constexpr int kCalm = 60;

}  // namespace

DiffractionAverage::DiffractionAverage(std::span<const double> sizes,
                                       std::span<const double> shares) {
    double greatest = 0.0;
    for (std::size_t d = 0; d < sizes.size(); ++d) {
        greatest = std::max(greatest, sizes[d]);
        mean_size_ += shares[d] * sizes[d];
        mean_power_ += shares[d] * std::pow(sizes[d], 1.5);
    }
    step_ = kStep / greatest;
    const auto node_at = [&](double s) {
        Value sum{};
        for (std::size_t d = 0; d < sizes.size(); ++d) {
            const double x = sizes[d], u = x * s, weight = shares[d] * x * x * x;
            const double part = std::abs(u) < 1e-4 ? 0.5 : ::j1(u) / u;
            sum.diffracted += weight * x * part * part;
            sum.cross += weight * part * std::sin(u);
        }
        return sum;
    };
    // The first node lies one step before 0, where the functions go on evenly and oddly.
    auto nodes = std::make_shared<std::vector<Value>>();
    int calm = 0;
    for (double k = -1.0; calm < kCalm && k * kStep < kLast; ++k) {
        const double s = k * step_;
        nodes->push_back(node_at(s));
        const Value mean = far(std::max(s, step_));
        const auto near = [](double value, double to) {
            return std::abs(value - to) <= kWashedOut * to;
        };
        const bool washed_out = near(nodes->back().diffracted, mean.diffracted) &&
                                near(nodes->back().cross, mean.cross);
        calm = washed_out ? calm + 1 : 0;
    }
    nodes_ = std::move(nodes);
}

DiffractionAverage DiffractionAverage::rescaled(double ratio) const {
    DiffractionAverage result = *this;
    result.scale_ *= ratio;
    return result;
}

DiffractionAverage::Value DiffractionAverage::far(double s) const {
    // J_1²(u) → 1 / (πu), J_1(u) sin u → 1 / (2 √(πu)).
    const double root = std::sqrt(std::numbers::pi * s);
    return {mean_size_ / (std::numbers::pi * s * s * s), 0.5 * mean_power_ / (s * root)};
}

DiffractionAverage::Value DiffractionAverage::at(double s) const {
    const std::vector<Value>& nodes = *nodes_;
    const double scaled = s * scale_, position = scaled / step_ + 1.0;
    const double cube = scale_ * scale_ * scale_;
    Value value;
    if (position < double(nodes.size() - 2)) {
        const auto k = std::size_t(position);
        const double t = position - double(k);
        const double w0 = -t * (t - 1.0) * (t - 2.0) / 6.0,
                     w1 = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                     w2 = -(t + 1.0) * t * (t - 2.0) / 2.0, w3 = (t + 1.0) * t * (t - 1.0) / 6.0;
        const auto mix = [&](double Value::*part) {
            return w0 * nodes[k - 1].*part + w1 * nodes[k].*part + w2 * nodes[k + 1].*part +
                   w3 * nodes[k + 2].*part;
        };
        value = {mix(&Value::diffracted), mix(&Value::cross)};
    } else {
        value = far(scaled);
    }
    return {cube * scale_ * value.diffracted, cube * value.cross};
}

}  // namespace dewbow
