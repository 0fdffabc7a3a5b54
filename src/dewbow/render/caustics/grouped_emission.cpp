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

void GroupedEmission::weigh(std::size_t targets, const std::vector<bool>& dark, double whole) {
    one_ = targets != aims_.groups.size();
    std::vector<double> flux(targets, 0.0);
    double sum = 0.0;
    int lit = 0;
    for (std::size_t target = 0; target < targets; ++target) {
        if (dark[target]) continue;
        ++lit;
        double found = 0.0;
        for (int i = 0; i < aims_.looks; ++i)
            if (const auto ray = first_towards(int(target), even_point(i)))
                found += brightness(*ray) / ray->pdf;
        sum += flux[target] = found / aims_.looks;
    }
    if (lit == 0 || !(whole > 0.0)) return;
    power_ = std::max(sum, kLeastShare * whole);
    for (std::size_t target = 0; target < flux.size(); ++target)
        if (!dark[target])
            flux[target] =
                (sum > 0.0 ? (1.0 - kEvenShare) * flux[target] / sum : 0.0) + kEvenShare / lit;
    choose_.emplace(flux);
}

int GroupedEmission::target_of(const Ray& ray) const {
    const int first = source() == LightSample::Source::infinite
                          ? aims_.index.first_on_line(ray.origin, ray.direction)
                          : aims_.index.first_from(ray.origin, ray.direction);
    return one_ ? std::min(first, 0) : first;
}

std::optional<EmittedRay> GroupedEmission::first_towards(int target,
                                                         const std::array<double, 4>& u) const {
    std::optional<EmittedRay> ray = towards(target, u);
    if (ray && target_of(ray->ray) != target) ray.reset();
    return ray;
}

std::optional<EmittedRay> GroupedEmission::ray(const std::array<double, 4>& u) const {
    if (!choose_) return std::nullopt;
    const Distribution1D::Sample choice = choose_->sample(u[axis_]);
    std::array<double, 4> rest = u;
    rest[axis_] = choice.offset;
    std::optional<EmittedRay> ray = first_towards(int(choice.index), rest);
    if (ray) ray->pdf *= choose_->probability(choice.index);
    return ray;
}

std::optional<EmissionMap::Place> GroupedEmission::place(const Ray& ray) const {
    const int target = choose_ ? target_of(ray) : -1;
    if (target < 0) return std::nullopt;
    const double chosen = choose_->probability(std::size_t(target));
    std::optional<Place> place = place_towards(target, ray);
    if (!place || !(place->pdf * chosen > 0.0)) return std::nullopt;
    place->u[axis_] = number_of(*choose_, std::size_t(target), place->u[axis_]);
    place->pdf *= chosen;
    return place;
}

}  // namespace dewbow::caustics
