// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/point_emission.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/render/brightness.h"

namespace dewbow::caustics {

PointEmission::PointEmission(const PunctualLight& light, int index, const Aims& aims)
    : GroupedEmission(LightSample::Source::punctual, index, aims, 0),
      light_(light),
      position_(light.position()),
      brightness_(dewbow::brightness(light.spectrum())) {
    const LightBounds bounds = light.bounds();
    const double half =
        std::min(bounds.normals.half_angle_rad + bounds.emission_rad, std::numbers::pi);
    axis_ = {bounds.normals.axis};
    width_ = one_minus_cos(half * unit::rad);
    const double cone_sr = 1.0 / pdf_uniform_cone(width_);
    double all_sr = 0.0;
    for (const CasterBounds& group : groups()) {
        to_.push_back(DirectionsTo::from(position_, group));
        if (to_.back() && to_.back()->solid_angle() > cone_sr) to_.back().reset();
        all_sr += to_.back() ? to_.back()->solid_angle() : cone_sr;
    }
    if (all_sr >= cone_sr && !groups().empty()) to_.assign(1, std::nullopt);
    weigh(to_.size(), std::vector<bool>(to_.size(), false), bounds.intensity * cone_sr);
}

std::optional<EmittedRay> PointEmission::towards(int target, const std::array<double, 4>& u) const {
    const auto& to = to_[std::size_t(target)];
    const std::array<double, 2> square{u[0], u[1]};
    const auto [direction, pdf] =
        to ? to->sample(square)
           : DirectionsTo::Sample{around(axis_, sample_uniform_cone(width_, u[0], u[1])).v,
                                  pdf_uniform_cone(width_)};
    const double factor = light_.factor(direction);
    if (!(factor > 0.0) || !(pdf > 0.0)) return std::nullopt;
    EmittedRay ray = lit({position_, direction, {}}, pdf, true);
    ray.factor = factor;
    return ray;
}

std::optional<EmissionMap::Place> PointEmission::place_towards(int target, const Ray& ray) const {
    if (!(light_.factor(ray.direction) > 0.0)) return std::nullopt;
    if (const auto& to = to_[std::size_t(target)]) {
        const auto place = to->place_of(ray.direction);
        if (!place) return std::nullopt;
        return Place{{place->u[0], place->u[1], 0.5, 0.5}, place->pdf};
    }
    const auto u = square_from_uniform_cone(width_, from_axis(axis_, Dir<World>{ray.direction}));
    return Place{{u[0], u[1], 0.5, 0.5}, pdf_uniform_cone(width_)};
}

double PointEmission::brightness(const EmittedRay& ray) const { return brightness_ * ray.factor; }

}  // namespace dewbow::caustics
