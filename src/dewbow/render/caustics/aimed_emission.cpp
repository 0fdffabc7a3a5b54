// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/aimed_emission.h"

#include <algorithm>

namespace dewbow::caustics {

namespace {

/// Of the first choice among lamps, what falls on all alike that shine on a caster: their power is
/// a guess.
constexpr double kEvenShare = 0.1;

/// Where each lamp begins and the last one ends; all 0 if none has power.
std::vector<double> edges_of(const EmissionMaps& maps) {
    double power = 0.0;
    int shining = 0;
    for (int i = 0; i < maps.size(); ++i)
        power += maps[i].power(), shining += maps[i].power() > 0.0;
    std::vector<double> edges(std::size_t(maps.size()) + 1, 0.0);
    if (shining == 0) return edges;
    std::size_t last = 0;
    for (int i = 0; i < maps.size(); ++i) {
        const auto at = std::size_t(i);
        edges[at + 1] = edges[at];
        if (!(maps[i].power() > 0.0)) continue;
        edges[at + 1] += (1.0 - kEvenShare) * maps[i].power() / power + kEvenShare / shining;
        last = at + 1;
    }
    std::fill(edges.begin() + std::ptrdiff_t(last), edges.end(), 1.0);
    return edges;
}

}  // namespace

AimedEmission::AimedEmission(const PreparedScene& prepared)
    : prepared_(prepared),
      casters_(prepared.scene, prepared.see_through),
      maps_(prepared, casters_),
      edges_(edges_of(maps_)) {}

std::size_t AimedEmission::lamp_at(double choice) const {
    const auto after = std::upper_bound(edges_.begin(), edges_.end(), choice);
    return std::size_t(after - edges_.begin()) - 1;
}

AimedEmission::Aim AimedEmission::aim(const AimPoint& u) const {
    const LearntDensity::Sample sample = density_.sample(u);
    Aim aim{sample.at, sample.density, std::nullopt};
    const std::size_t lamp = lamp_at(sample.at[0]);
    aim.ray = maps_[int(lamp)].ray({sample.at[1], sample.at[2], sample.at[3], sample.at[4]});
    if (!aim.ray) return aim;
    aim.ray->pdf *= sample.density * (edges_[lamp + 1] - edges_[lamp]);
    return aim;
}

AimPoint AimedEmission::numbers(const SampleKey& key) {
    const std::array<double, 2> place = key.two(0, Purpose::light_point);
    return {key.one(0, Purpose::light_choice), place[0], place[1],
            key.third(0, Purpose::light_point), key.fourth(0, Purpose::light_point)};
}

std::optional<EmittedRay> AimedEmission::sample(double u_light,
                                                const std::array<double, 4>& u) const {
    return aim({u_light, u[0], u[1], u[2], u[3]}).ray;
}

/// Of a ray that leaves that lamp, which has extent.
double AimedEmission::density_of(std::size_t lamp, const Ray& ray) const {
    const double low = edges_[lamp], share = edges_[lamp + 1] - low;
    if (!(share > 0.0)) return 0.0;
    const auto place = maps_[int(lamp)].place(ray);
    if (!place) return 0.0;
    const auto& [u, pdf] = *place;
    return share * pdf * density_.density({low + 0.5 * share, u[0], u[1], u[2], u[3]});
}

double AimedEmission::density_of_hit(const Hit& lamp, Vec3 point, const Ray& camera_ray) const {
    const int number = prepared_.lights.glowing_of(lamp.shape);
    if (number < 0) return 0.0;
    const Vec3 direction = -camera_ray.direction;
    const SurfaceFrom from{lamp.shape, lamp.primitive, dot(direction, lamp.normal) < 0.0};
    return density_of(std::size_t(maps_.of(LightSample::Source::shape, number)),
                      {point, direction, from});
}

double AimedEmission::density_of_infinite(int i, const Ray& camera_ray) const {
    return density_of(std::size_t(maps_.of(LightSample::Source::infinite, i)),
                      {camera_ray.origin, -camera_ray.direction, {}});
}

double AimedEmission::density_of_sample(const LightSample& light, Vec3 receiver) const {
    const bool afar = light.source == LightSample::Source::infinite;
    const Ray ray{afar ? receiver : receiver + light.direction * light.distance,
                  -light.direction,
                  {-1, light.primitive, false}};
    const auto lamp = std::size_t(maps_.of(light.source, light.index));
    if (!light.without_extent) return density_of(lamp, ray);
    const auto place = maps_[int(lamp)].place(ray);
    return place ? (edges_[lamp + 1] - edges_[lamp]) * place->pdf : 0.0;
}

}  // namespace dewbow::caustics
