// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/grouped_emission.h"

#include <algorithm>
#include <cmath>

namespace dewbow::caustics {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1
/// Share of the choices that falls on all targets alike: what a target gets is an estimate.
constexpr double kEvenShare = 0.1;
/// A lamp whose looks found nothing may still give this share of its light.
constexpr double kLeastShare = 1e-4;

/// Even points in four dimensions: multiples of powers of 1 / x, where x⁵ = x + 1.
/// [Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018]
std::array<double, 4> even_point(int i) {
    constexpr double kX = 1.1673039782614187;
    std::array<double, 4> u;
    double step = 1.0;
    for (double& v : u) {
        step /= kX;
        v = std::fmod(0.5 + (i + 1) * step, 1.0);
    }
    return u;
}

}  // namespace

double number_of(const Distribution1D& distribution, std::size_t cell, double offset) {
    const double low = distribution.cdf(double(cell) / double(distribution.size()));
    return std::clamp(low + offset * distribution.probability(cell), 0.0, kOneBelow);
}

void GroupedEmission::weigh(int targets, const std::vector<bool>& dark, double whole) {
    std::vector<double> flux(std::size_t(targets), 0.0);
    double sum = 0.0;
    int lit = 0;
    for (int target = 0; target < targets; ++target) {
        if (dark[std::size_t(target)]) continue;
        ++lit;
        double found = 0.0;
        for (int i = 0; i < aims_.looks; ++i)
            if (const auto ray = towards(target, even_point(i)))
                found += brightness(*ray) / ray->pdf;
        sum += flux[std::size_t(target)] = found / aims_.looks;
    }
    if (lit == 0 || !(whole > 0.0)) return;
    power_ = std::max(sum, kLeastShare * whole);
    for (std::size_t target = 0; target < flux.size(); ++target)
        if (!dark[target])
            flux[target] =
                (sum > 0.0 ? (1.0 - kEvenShare) * flux[target] / sum : 0.0) + kEvenShare / lit;
    choose_.emplace(flux);
}

std::optional<EmittedRay> GroupedEmission::ray(const std::array<double, 4>& u) const {
    if (!choose_) return std::nullopt;
    const Distribution1D::Sample choice = choose_->sample(u[axis_]);
    std::array<double, 4> rest = u;
    rest[axis_] = choice.offset;
    std::optional<EmittedRay> ray = towards(int(choice.index), rest);
    if (ray) ray->pdf *= choose_->probability(choice.index);
    return ray;
}

int GroupedEmission::places(const Ray& ray, std::span<Place> places) const {
    if (!choose_) return 0;
    int count = 0;
    for (std::size_t target = 0; target < choose_->size(); ++target) {
        const double chosen = choose_->probability(target);
        if (!(chosen > 0.0) || !may_meet(target, ray)) continue;
        std::optional<Place> place = place_towards(int(target), ray);
        if (!place || !(place->pdf > 0.0)) continue;
        place->u[axis_] = number_of(*choose_, target, place->u[axis_]);
        place->pdf *= chosen;
        places[std::size_t(count++)] = *place;
    }
    return count;
}

/// Whether the whole line passes the ball around a target: cheaper than whether it meets it.
bool GroupedEmission::may_meet(std::size_t target, const Ray& ray) const {
    if (choose_->size() != aims_.around.size()) return true;  // one target for all groups
    constexpr double kRounding = 1.0 + 1e-6;
    const Ball& ball = aims_.around[target];
    const Vec3 to_centre = ball.centre - ray.origin;
    const Vec3 aside = to_centre - ray.direction * dot(to_centre, ray.direction);
    return dot(aside, aside) <= ball.radius * ball.radius * kRounding;
}

bool GroupedEmission::meets_any(Vec3 origin, Vec3 direction) const {
    return std::any_of(aims_.groups.begin(), aims_.groups.end(),
                       [&](const CasterBounds& group) { return group.met_by(origin, direction); });
}

}  // namespace dewbow::caustics
