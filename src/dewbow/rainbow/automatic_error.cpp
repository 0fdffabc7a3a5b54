// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic_error.h"

#include <algorithm>
#include <array>

namespace dewbow {

using namespace unit;

std::span<const RegionError> composition_errors(bool point) {
    // n = 1.325 to 1.345, widths 5 to 20 %, x = 250 to 9600 (LongAutomatic.ErrorsAreThoseStated).
    // The glory is always left to Mie theory: it hangs on orders far above 7, and on the index.
    static const std::array<RegionError, 11> disc = {{
        {{0.0 * deg, 6.0 * deg}, 0.016, 0.013},
        {{6.0 * deg, 15.0 * deg}, 0.009, 0.004},
        {{15.0 * deg, 46.0 * deg}, 0.012, 0.016},
        {{46.0 * deg, 60.0 * deg}, 0.016, 0.008},
        {{60.0 * deg, 82.0 * deg}, 0.016, 0.002},
        {{82.0 * deg, 125.0 * deg}, 0.009, 0.002},
        {{125.0 * deg, 150.0 * deg}, 0.015, 0.003},
        {{150.0 * deg, 155.0 * deg}, 0.019, 0.002},
        {{155.0 * deg, 170.0 * deg}, 0.030, 0.003},
        {{170.0 * deg, 176.0 * deg}, 0.032, 0.012},
        {{176.0 * deg, 180.0 * deg}, 1.0, 1.0},
    }};
    static const std::array<RegionError, 11> without = [] {
        std::array<RegionError, 11> errors = disc;
        errors.front().least = 0.3;  // rings
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
