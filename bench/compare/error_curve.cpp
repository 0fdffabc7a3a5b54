// SPDX-License-Identifier: Apache-2.0
#include "error_curve.h"

#include <algorithm>
#include <cmath>

namespace dewbow::bench {

ErrorCurve::ErrorCurve(std::vector<CurvePoint> points) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end(),
              [](const CurvePoint& a, const CurvePoint& b) { return a.time_s < b.time_s; });
}

std::optional<double> ErrorCurve::error_at(double time_s) const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const CurvePoint& right = points_[i];
        if (right.time_s == time_s) return right.error;
        if (right.time_s < time_s) continue;
        if (i == 0) return std::nullopt;
        const CurvePoint& left = points_[i - 1];
        if (!(left.error > 0.0 && right.error > 0.0 && left.time_s > 0.0)) return std::nullopt;
        const double share = std::log(time_s / left.time_s) / std::log(right.time_s / left.time_s);
        return left.error * std::pow(right.error / left.error, share);
    }
    return std::nullopt;
}

}  // namespace dewbow::bench
