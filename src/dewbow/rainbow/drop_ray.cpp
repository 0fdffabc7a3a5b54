// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_ray.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

DropRay drop_ray(double b, RelativeIndex n) {
    return {std::asin(b) * unit::rad, std::asin(b / n.value) * unit::rad};
}

Angle deviation(const DropRay& ray, int p) {
    return (p - 1) * kPi * unit::rad + 2.0 * ray.incidence - 2.0 * p * ray.refraction;
}

Angle scattering_angle(Angle deviation) {
    return std::abs(std::remainder(deviation.to(unit::rad), 2.0 * kPi)) * unit::rad;
}

double deviation_slope(const DropRay& ray, RelativeIndex n, int p) {
    return 2.0 / cos(ray.incidence) - 2.0 * p / (n.value * cos(ray.refraction));
}

RayAmplitudes ray_amplitudes(const DropRay& ray, RelativeIndex n, int p) {
    // In cosines: the sines of i − r and i + r vanish together at the centre.
    const double ci = cos(ray.incidence), cr = cos(ray.refraction);
    const double rs = (ci - n.value * cr) / (ci + n.value * cr);
    const double rp = (n.value * ci - cr) / (n.value * ci + cr);
    if (p == 0) return {rs, rp};
    return {(1.0 - rs * rs) * std::pow(-rs, p - 1), (1.0 - rp * rp) * std::pow(-rp, p - 1)};
}

DescartesRay descartes_ray(RelativeIndex n, int p) {
    if (p < 2 || !(n.value > 1.0 && n.value < p))
        throw InputError(fmt::format(
            "no bow of order {} at index {}; expected order 2 or more, index above 1 and below the "
            "order",
            p, n.value));
    const double n2 = n.value * n.value, p2 = double(p) * p;
    DescartesRay bow;
    bow.p = p;
    bow.impact_parameter = std::sqrt((p2 - n2) / (p2 - 1.0));
    bow.ray = drop_ray(bow.impact_parameter, n);
    bow.deviation = deviation(bow.ray, p);
    bow.scattering_angle = scattering_angle(bow.deviation);
    bow.bright_side = std::remainder(bow.deviation.to(unit::rad), 2.0 * kPi) > 0.0 ? 1 : -1;
    bow.airy_constant = (p2 - 1.0) * (p2 - 1.0) / p2 *
                        std::sqrt((p2 - n2) / ((n2 - 1.0) * (n2 - 1.0) * (n2 - 1.0)));
    return bow;
}

}  // namespace dewbow
