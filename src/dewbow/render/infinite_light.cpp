// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/infinite_light.h"

#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/render/brightness.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;

/// Radiance of a disc in the sky that gives irradiance 1 to a surface which faces it: 1 / (π sin²
/// α), with 1 − cos α = `width`. Beyond the hemisphere nothing is added.
double radiance_of_disc(double width) {
    return 1.0 / (kPi * (width < 1.0 ? width * (2.0 - width) : 1.0));
}

}  // namespace

bool InfiniteLight::holds(const Light& light) {
    return std::holds_alternative<DistantLight>(light) ||
           std::holds_alternative<UniformEnvironment>(light) ||
           std::holds_alternative<std::shared_ptr<const ImageEnvironment>>(light) ||
           std::holds_alternative<SkyDomePtr>(light);
}

InfiniteLight::InfiniteLight(const Light& light) {
    if (const auto* distant = std::get_if<DistantLight>(&light)) {
        cone_width_ = one_minus_cos(distant->angular_radius);
        kind_ = cone_width_ > 0.0 ? Kind::disc : Kind::parallel;
        axis_ = -distant->direction.v;
        spectrum_ = distant->irradiance;
        if (kind_ == Kind::disc) factor_ = radiance_of_disc(cone_width_);
        irradiance_ = dewbow::brightness(*spectrum_);
    } else if (const auto* even = std::get_if<UniformEnvironment>(&light)) {
        kind_ = Kind::even;
        spectrum_ = even->radiance;
        irradiance_ = kPi * dewbow::brightness(*spectrum_);
    } else if (const auto* sky = std::get_if<SkyDomePtr>(&light)) {
        kind_ = Kind::sky;
        sky_.emplace(*sky);
        irradiance_ = kPi * sky_->mean_brightness();
    } else {
        kind_ = Kind::picture;
        map_.emplace(std::get<std::shared_ptr<const ImageEnvironment>>(light));
        irradiance_ = kPi * map_->mean_y();
    }
}

std::optional<InfiniteLight::Sample> InfiniteLight::sample(std::array<double, 2> u) const {
    switch (kind_) {
        case Kind::parallel:
            return Sample{axis_, 1.0};
        case Kind::disc: {
            const Dir<Local> d = sample_uniform_cone(cone_width_, u[0], u[1]);
            return Sample{around(Dir<World>{axis_}, d).v, pdf_uniform_cone(cone_width_)};
        }
        case Kind::even:
            return Sample{sample_uniform_sphere<World>(u[0], u[1]).v, pdf_uniform_sphere()};
        case Kind::sky: {
            const auto s = sky_->sample(u);
            if (!s) return std::nullopt;
            return Sample{s->direction, s->pdf};
        }
        default: {
            const EnvironmentMap::Sample s = map_->sample(u);
            if (!(s.pdf > 0.0)) return std::nullopt;
            return Sample{s.direction, s.pdf};
        }
    }
}

double InfiniteLight::pdf(Vec3 direction) const {
    switch (kind_) {
        case Kind::parallel:
            return 0.0;
        case Kind::disc:
            return pdf_uniform_cone(cone_width_);
        case Kind::even:
            return pdf_uniform_sphere();
        case Kind::sky:
            return sky_->pdf(direction);
        default:
            return map_->pdf(direction);
    }
}

std::array<double, 2> InfiniteLight::place_of(Vec3 direction) const {
    switch (kind_) {
        case Kind::parallel:
            return {0.5, 0.5};
        case Kind::disc:
            return square_from_uniform_cone(cone_width_,
                                            from_axis(Dir<World>{axis_}, Dir<World>{direction}));
        case Kind::even:
            return square_from_uniform_sphere(Dir<World>{direction});
        case Kind::sky:
            return sky_->place_of(direction);
        default:
            return map_->place_of(direction);
    }
}

double InfiniteLight::brightness(Vec3 direction) const {
    if (kind_ == Kind::picture) return xyz_from_rgb(map_->radiance(direction))[1];
    if (kind_ == Kind::sky) return sky_->brightness(direction);
    return kind_ == Kind::even ? irradiance_ / kPi : factor_ * irradiance_;
}

bool InfiniteLight::shows(Vec3 direction) const {
    if (kind_ == Kind::parallel) return false;
    if (kind_ != Kind::disc) return true;
    // |a − b|² / 2 = 1 − cos of the angle between them, without cancellation.
    const Vec3 apart = direction - axis_;
    return 0.5 * dot(apart, apart) <= cone_width_;
}

void InfiniteLight::radiance(Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb,
                             LaneValues& out) const {
    if (kind_ == Kind::picture) {
        rgb.eval(map_->radiance(direction), lanes, out);
        return;
    }
    if (kind_ == Kind::sky) {
        sky_->sky().radiance_lanes({direction}, lanes.lambdas(), out.first(lanes.count));
        return;
    }
    spectrum_->eval_lanes(lanes.lambdas(), out.first(lanes.count));
    for (int k = 0; k < lanes.count; ++k) out[k] *= factor_;
}

}  // namespace dewbow
