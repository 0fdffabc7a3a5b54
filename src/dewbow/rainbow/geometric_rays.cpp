// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/geometric_rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// 2i − 2pr, the deflection less that of the ray along the axis, and its derivative by i.
struct Turn {
    double value, slope;
};
Turn turn(double incidence, double n, int p) {
    const double b = std::sin(incidence);
    return {2.0 * incidence - 2.0 * p * std::asin(b / n),
            2.0 - 2.0 * p * std::cos(incidence) / std::sqrt(n * n - b * b)};
}

/// b / |sin θ|, with its limit on the axis.
double impact_over_sine(double incidence, const Turn& at, double n, int p) {
    if (incidence == 0.0) return 1.0 / std::abs(2.0 - 2.0 * p / n);
    return std::sin(incidence) / std::abs(std::sin(at.value));
}

GeometricRay ray_of(Angle incidence, RelativeIndex n, int p) {
    const double i = incidence.to(unit::rad), b = std::sin(i);
    const Turn at = turn(i, n.value, p);
    GeometricRay result;
    result.ray = {incidence, std::asin(b / n.value) * unit::rad};
    result.impact_parameter = b;
    result.slope = std::abs(at.slope) / std::cos(i);
    result.amplitudes = ray_amplitudes(result.ray, n, p);
    const double geometry = impact_over_sine(i, at, n.value, p) * std::cos(i) / std::abs(at.slope);
    const auto square = [](double v) { return v * v; };
    result.intensity = {square(result.amplitudes.perpendicular) * geometry,
                        square(result.amplitudes.parallel) * geometry};
    return result;
}

}  // namespace

Angle RayBranch::incidence_at(Angle theta) const {
    const double wanted = level_ + side_ * theta.to(unit::rad);
    if (p == 0) return std::clamp(0.5 * wanted, from_, to_) * unit::rad;
    if (p == 1) {  // sin i = n sin(i − t) with t = i − r
        const double t = 0.5 * wanted;
        return std::atan2(n.value * std::sin(t), n.value * std::cos(t) - 1.0) * unit::rad;
    }
    // The root of the distance from the least turn is nearly linear in i, through the bow as well:
    // Newton's method on it takes three or four steps from the straight line between the ends.
    const auto root = [&](double value) { return std::sqrt(std::max(value - least_, 0.0)); };
    const double y = root(wanted), y_from = root(at_from_), y_to = root(at_to_);
    double low = from_, high = to_;
    double i = low + (y - y_from) / (y_to - y_from) * (high - low);
    constexpr int kMostSteps = 60;  // bisection alone is through by then
    for (int step = 0; step < kMostSteps; ++step) {
        i = std::clamp(i, low, high);
        const Turn at = turn(i, n.value, p);
        const double error = at.value - wanted;
        if (error == 0.0) break;
        ((error > 0.0) == (at_to_ > at_from_) ? high : low) = i;
        const double y_at = root(at.value);
        double next = i - error * 2.0 * y_at / ((y_at + y) * at.slope);
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        constexpr double kLastStep = 1e-10;  // the next one would be its square
        const bool done = std::abs(next - i) <= kLastStep * i;
        i = next;
        if (done) break;
    }
    return i * unit::rad;
}

std::vector<RayBranch> ray_branches(RelativeIndex n, int p) {
    if (p < 0 || !(n.value > 1.0))
        throw InputError(fmt::format(
            "no rays of order {} at index {}; expected order 0 or more and an index above 1", p,
            n.value));
    const double edge = 0.5 * kPi,
                 bow = p < 2 ? 0.0 : descartes_ray(n, p).ray.incidence.to(unit::rad);
    std::vector<RayBranch> branches;
    const auto add_monotone = [&](double from, double to) {
        RayBranch branch;
        branch.p = p, branch.n = n;
        branch.from_ = from, branch.to_ = to;
        branch.at_from_ = turn(from, n.value, p).value, branch.at_to_ = turn(to, n.value, p).value;
        branch.least_ = std::min(branch.at_from_, branch.at_to_);
        // Cut where the deflection passes a multiple of π.
        const double least = branch.least_, greatest = std::max(branch.at_from_, branch.at_to_);
        std::vector<RayBranch> parts;
        for (double m = std::floor(least / kPi); m * kPi < greatest; ++m) {
            const double low = std::max(least, m * kPi), high = std::min(greatest, (m + 1) * kPi);
            const bool folded = (int(m) + p - 1) % 2 != 0;
            branch.side_ = folded ? -1 : 1;
            branch.level_ = (folded ? m + 1 : m) * kPi;
            const auto theta = [&](double v) { return branch.side_ * (v - branch.level_); };
            branch.least = (folded ? theta(high) : theta(low)) * unit::rad;
            branch.greatest = (folded ? theta(low) : theta(high)) * unit::rad;
            parts.push_back(branch);
        }
        if (branch.at_to_ < branch.at_from_) std::reverse(parts.begin(), parts.end());
        branches.insert(branches.end(), parts.begin(), parts.end());
    };
    if (bow > 0.0) add_monotone(0.0, bow);
    add_monotone(bow, edge);
    return branches;
}

std::vector<GeometricRay> geometric_rays(const std::vector<RayBranch>& branches, Angle theta) {
    std::vector<GeometricRay> rays;
    for (const RayBranch& branch : branches)
        if (theta >= branch.least && theta <= branch.greatest)
            rays.push_back(ray_of(branch.incidence_at(theta), branch.n, branch.p));
    return rays;
}

std::vector<GeometricRay> geometric_rays(RelativeIndex n, int p, Angle theta) {
    return geometric_rays(ray_branches(n, p), theta);
}

Intensities geometric_intensity(RelativeIndex n, int p, Angle theta) {
    Intensities sum;
    for (const GeometricRay& ray : geometric_rays(n, p, theta)) {
        sum.perpendicular += ray.intensity.perpendicular;
        sum.parallel += ray.intensity.parallel;
    }
    return sum;
}

}  // namespace dewbow
