// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/geometric_rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// 2i − 2pr, the deflection less that of the ray along the axis, and its derivative by i.
struct Turn {
    double value, slope, sine, cosine;
};
Turn turn(double incidence, double n, int p) {
    const double b = std::sin(incidence), c = std::cos(incidence);
    return {2.0 * incidence - 2.0 * p * std::asin(b / n),
            2.0 - 2.0 * p * c / std::sqrt(n * n - b * b), b, c};
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

RaySearch::RaySearch(const RayBranch& branch)
    : branch_(branch),
      root_from_(root(branch.at_from_)),
      root_to_(root(branch.at_to_)),
      mean_slope_((branch.to_ - branch.from_) / (root_to_ - root_from_)),
      incidence_(branch.from_),
      root_(root_from_),
      slope_(mean_slope_) {}

/// The root of the distance from the least turn is nearly linear in i, through the bow as well.
double RaySearch::root(double turn) const {
    return std::sqrt(std::max(turn - branch_.least_, 0.0));
}

RaySearch::Ray RaySearch::at(Angle theta) {
    const double n = branch_.n.value;
    const double wanted = branch_.level_ + branch_.side_ * theta.to(unit::rad);
    if (branch_.p > 1) return bracketed(wanted);
    const double t = 0.5 * wanted;  // i, or i − r with sin i = n sin(i − t)
    const double i = branch_.p == 0 ? std::clamp(t, branch_.from_, branch_.to_)
                                    : std::atan2(n * std::sin(t), n * std::cos(t) - 1.0);
    return {i, std::sin(i), std::cos(i)};
}

/// Newton's method on the root, from the straight line through the last ray: four steps at first,
/// one or two for a neighbour.
RaySearch::Ray RaySearch::bracketed(double wanted) {
    // The bow's ray is the same from both sides: between two answers some flux would be lost.
    constexpr double kRounding = 8e-15;
    for (const auto& [end, turn_there] :
         {std::pair{branch_.from_, branch_.at_from_}, std::pair{branch_.to_, branch_.at_to_}})
        if (std::abs(wanted - turn_there) < kRounding) return {end, std::sin(end), std::cos(end)};
    const double y = root(wanted);
    double low = branch_.from_, high = branch_.to_;
    double i = incidence_ + (y - root_) * slope_;
    Ray ray;
    constexpr int kMostSteps = 60;  // bisection alone is through by then
    for (int step = 0; step < kMostSteps; ++step) {
        i = std::clamp(i, low, high);
        const Turn at = turn(i, branch_.n.value, branch_.p);
        ray = {i, at.sine, at.cosine};
        const double error = at.value - wanted, y_at = root(at.value);
        // At the bow itself both vanish: there the straight line between the ends is as good.
        slope_ = y_at > 0.0 ? 2.0 * y_at / at.slope : mean_slope_;
        if (error == 0.0) break;
        ((error > 0.0) == (root_to_ > root_from_) ? high : low) = i;
        double change = -error * slope_ / (y_at + y);
        if (!(i + change >= low && i + change <= high)) change = 0.5 * (low + high) - i;
        i += change;
        constexpr double kLastStep = 1e-8;  // the next one would be about its square
        if (std::abs(change) > kLastStep * i) continue;
        ray = {i, at.sine + change * at.cosine, at.cosine - change * at.sine};
        break;
    }
    incidence_ = ray.incidence, root_ = y;
    return ray;
}

Angle RayBranch::incidence_at(Angle theta) const {
    return RaySearch(*this).at(theta).incidence * unit::rad;
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
