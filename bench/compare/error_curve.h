// SPDX-License-Identifier: Apache-2.0
#pragma once

// Error over time, as measured: a few points, and lines between them.

#include <optional>
#include <vector>

namespace dewbow::bench {

struct CurvePoint {
    double time_s = 0.0, error = 0.0;
};

/// Points by rising time. Straight between two of them in logarithms of both; where an error is 0,
/// and beyond the first and the last point, there is nothing: what was not measured is not claimed.
class ErrorCurve {
public:
    explicit ErrorCurve(std::vector<CurvePoint> points);
    std::optional<double> error_at(double time_s) const;
    const std::vector<CurvePoint>& points() const { return points_; }

private:
    std::vector<CurvePoint> points_;
};

}  // namespace dewbow::bench
