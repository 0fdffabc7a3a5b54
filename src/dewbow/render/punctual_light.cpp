// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/punctual_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/render/brightness.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
/// Least difference of the cosines of a spot's two angles: a jump would have no slope.
constexpr double kLeastFallOff = 1e-9;

LightBounds bounds_at(Point<World> position, const Spectrum& spectrum, double intensity) {
    LightBounds bounds;
    bounds.box.add(position.v);
    bounds.intensity = brightness(spectrum) * intensity;
    bounds.normals = DirectionCone::all();
    bounds.emission_rad = kPi / 2.0;
    return bounds;
}

/// θ of the last direction from nadir that is not dark.
double lit_cone_rad(const PhotometricTable& table) {
    const std::size_t columns = table.vertical_deg.size();
    std::size_t last = 0;
    for (std::size_t i = 0; i < table.intensity_cd.size(); ++i)
        if (table.intensity_cd[i] > 0.0) last = std::max(last, i % columns);
    return table.vertical_deg[std::min(last + 1, columns - 1)] * kPi / 180.0;
}

}  // namespace

bool PunctualLight::holds(const Light& light) {
    return std::holds_alternative<PointLight>(light) || std::holds_alternative<SpotLight>(light) ||
           std::holds_alternative<ProfileLight>(light);
}

PunctualLight::PunctualLight(const Light& light) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
        light_ = *point;
    } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
        light_ = *spot;
        cos_outer_ = cos(spot->outer);
        per_cosine_ = 1.0 / std::max(cos(spot->inner) - cos_outer_, kLeastFallOff);
    } else {
        light_ = std::get<ProfileLight>(light);
    }
}

std::optional<Arrival> PunctualLight::arrival(Vec3 at) const {
    const Vec3 to_light = position() - at;
    const double d2 = dot(to_light, to_light);
    if (!(d2 > 0.0)) return std::nullopt;
    const double distance = std::sqrt(d2);
    Arrival arrival{to_light / distance, distance, 1.0 / d2};
    arrival.factor *= factor(-arrival.direction);
    if (!(arrival.factor > 0.0)) return std::nullopt;
    return arrival;
}

Vec3 PunctualLight::position() const {
    return std::visit([](const auto& light) { return light.position.v; }, light_);
}

double PunctualLight::factor(Vec3 leaving) const {
    if (const auto* spot = std::get_if<SpotLight>(&light_)) {
        const double cosine = dot(leaving, spot->direction.v);
        const double inside = std::clamp((cosine - cos_outer_) * per_cosine_, 0.0, 1.0);
        return inside * inside;
    }
    if (const auto* profile = std::get_if<ProfileLight>(&light_))
        return profile->web->intensity_cd(
            profile->world_from_object.inverse()(Dir<World>{leaving}));
    return 1.0;
}

LightBounds PunctualLight::bounds() const {
    if (const auto* point = std::get_if<PointLight>(&light_))
        return bounds_at(point->position, spectrum(), 1.0);
    if (const auto* spot = std::get_if<SpotLight>(&light_)) {
        LightBounds bounds = bounds_at(spot->position, spectrum(), 1.0);
        bounds.normals = {spot->direction.v, spot->inner.to(unit::rad)};
        bounds.emission_rad = (spot->outer - spot->inner).to(unit::rad);
        return bounds;
    }
    const auto& profile = std::get<ProfileLight>(light_);
    LightBounds bounds = bounds_at(profile.position, spectrum(), profile.web->max_intensity_cd());
    const Vec3 nadir = normalised(profile.world_from_object(Dir<Object>{{0.0, -1.0, 0.0}}).v);
    bounds.normals = {nadir, lit_cone_rad(profile.web->table())};
    bounds.emission_rad = 0.0;
    return bounds;
}

const Spectrum& PunctualLight::spectrum() const {
    if (const auto* profile = std::get_if<ProfileLight>(&light_)) return *profile->intensity_per_cd;
    if (const auto* spot = std::get_if<SpotLight>(&light_)) return *spot->intensity;
    return *std::get<PointLight>(light_).intensity;
}

Beam::Beam(const BeamLight& light)
    : light_(light),
      radius2_m2_(std::pow(light.radius.to(unit::m), 2.0)),
      brightness_(brightness(*light.irradiance)) {}

std::optional<Arrival> Beam::arrival(Vec3 at) const {
    const Vec3 from_disc = at - light_.position.v;
    const double along = dot(from_disc, light_.direction.v);
    const Vec3 aside = from_disc - light_.direction.v * along;
    if (!(along > 0.0) || dot(aside, aside) > radius2_m2_) return std::nullopt;
    return Arrival{-light_.direction.v, along, 1.0};
}

double Beam::irradiance(const Receiver& receiver) const {
    if (receiver.one_sided() && dot(receiver.normal, light_.direction.v) >= 0.0) return 0.0;
    return arrival(receiver.position) ? brightness_ : 0.0;
}

}  // namespace dewbow
