// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/bow_passages.h"

#include <cmath>
#include <numbers>

#include "dewbow/math/root_finding.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {

SingleRay single_ray(const BowGeometry& bow, double deviation, double sine) {
    const RelativeIndex n{bow.n};
    const auto excess = [&](double i) {
        return bow.most + 2.0 * i - 2.0 * bow.p * std::asin(std::sin(i) / bow.n) - deviation;
    };
    const double b = std::sin(find_root(excess, 0.0, bow.incidence).value_or(0.0));
    const DropRay ray = drop_ray(b, n);
    const double slope = std::abs(deviation_slope(ray, n, bow.p));
    // Beside the axis sin θ is |dD/db| b for a ray along it; there rounding would have the say.
    constexpr double kAxial = 1e-6;
    const double scale = std::sqrt((b < kAxial ? 1.0 / slope : b / sine) / slope);
    const RayAmplitudes left = ray_amplitudes(ray, n, bow.p);
    return {b, 2.0 * (bow.p * bow.n * cos(ray.refraction) - cos(ray.incidence)),
            left.perpendicular * scale, left.parallel * scale};
}

bool is_central(const BowGeometry& bow, double deviation) {
    return deviation > bow.grazing() && deviation > bow.most - 0.5 * std::numbers::pi;
}

}  // namespace dewbow
