// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic_error.h"

#include <algorithm>
#include <array>

namespace dewbow {
namespace {

using namespace unit;

}  // namespace

std::span<const RegionError> composition_errors(bool point) {
    static const std::array<RegionError, 11> disc = {{
        {{0.0 * deg, 6.0 * deg}, 0.016, 0.013},
        {{6.0 * deg, 15.0 * deg}, 0.009, 0.004},
        {{15.0 * deg, 46.0 * deg}, 0.012, 0.006},
        {{46.0 * deg, 60.0 * deg}, 0.014, 0.004},
        {{60.0 * deg, 82.0 * deg}, 0.016, 0.002},
        {{82.0 * deg, 125.0 * deg}, 0.009, 0.002},
        {{125.0 * deg, 150.0 * deg}, 0.011, 0.003},
        {{150.0 * deg, 155.0 * deg}, 0.019, 0.002},
        {{155.0 * deg, 170.0 * deg}, 0.028, 0.003},
        {{170.0 * deg, 177.0 * deg}, 0.030, 0.006},
        {{177.0 * deg, 180.0 * deg}, 0.300, 0.010},
    }};
    static const std::array<RegionError, 11> without = [] {
        std::array<RegionError, 11> errors = disc;
        errors.front().least = 0.30, errors.back().least = 1.0;
        return errors;
    }();
    return point ? without : disc;
}

AutomaticPlan plan_angles(double x, bool point, double tolerance) {
    AutomaticPlan plan;
    for (const RegionError& region : composition_errors(point)) {
        const double error = std::max(region.per_size * 1000.0 / x, region.least);
        if (error <= tolerance) {
            plan.error = std::max(plan.error, error);
        } else if (!plan.exact.empty() && plan.exact.back().to == region.range.from) {
            plan.exact.back().to = region.range.to;
        } else {
            plan.exact.push_back(region.range);
        }
    }
    return plan;
}

double exact_weight(std::span<const AngleRange> exact, Angle theta) {
    double weight = 0.0;
    for (const AngleRange& range : exact) {
        const Angle outside = std::max({range.from - theta, theta - range.to, 0.0 * deg});
        const double t = std::min(outside / kBlend, 1.0);
        weight = std::max(weight, 1.0 - t * t * (3.0 - 2.0 * t));
    }
    return weight;
}

}  // namespace dewbow
