// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>

#include "dewbow/render/caustics/haze_share.h"
#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

/// Light that comes straight from a lamp and is scattered into the path: single scattering.
///
/// $L_k = \sigma_{s,k}\, p_k(\cos\theta)\, e^{-\sigma_{t,k} t}\, E_k$ at one point of the flight,
/// taken with a density per metre; E of one light, taken with a density of directions.
/// [Kulla & Fajardo 2012, eq. 3]
void CameraWalk::light_in_haze(const SharedPath& path, const Hit& hit) {
    const Ray& ray = path.ray;
    const int medium = path.media.interior(), count = path.lanes.count;
    HazeLanes haze = haze_around(path.lanes, path.media);
    const DistanceDensity density = prepared_.haze->lamps.density(ray.origin, ray.direction, hit.t,
                                                                  haze.extinction.first(count));
    if (density.empty()) return;
    const std::uint32_t at = flight_key(path);
    const std::array<double, 2> u = key_.two(at, Purpose::haze);
    const double distance = density.sample(u[0]);
    const Vec3 point = ray.origin + ray.direction * distance;
    const std::optional<LightSample> light = prepared_.lights.sample(
        {point}, u[1], {key_.third(at, Purpose::haze), key_.fourth(at, Purpose::haze)});
    if (!light || !(light->pdf > 0.0)) return;
    if (prepared_.accelerator.occluded({point, light->direction, {}}, light->distance)) return;
    if (left_to_light_paths(path, point, *light)) return;

    LaneValues radiance, phase;
    prepared_.lights.radiance(*light, path.lanes, light_colours(), radiance);
    absorb(shadow_way(point, light->direction, light->distance, at), path.lanes, radiance,
           path.media);
    if (in_weather(path.media))
        dim({ray.origin, ray.direction, distance, at, Purpose::rain_on_flight}, path.lanes,
            radiance);
    prepared_.media.medium(medium).phase->eval_lanes(dot(ray.direction, light->direction),
                                                     path.lanes.lambdas(), phase.first(count));
    for (int k = 0; k < count; ++k)
        radiance[k] *= haze.scattering[k] * phase[k] * std::exp(-haze.extinction[k] * distance);
    add(path, radiance, 1.0 / (light->pdf * density.pdf(distance)));
}

/// Light at a point of haze that light paths bring to the camera (caustics/haze_share.h).
bool CameraWalk::left_to_light_paths(const SharedPath& path, Vec3 point,
                                     const LightSample& light) const {
    if (!light_paths_ || !path.sees_start()) return false;
    const bool from_afar = light.source == LightSample::Source::infinite;
    const Hit next = prepared_.accelerator.intersect({point, -light.direction, {}});
    return caustics::light_paths_find(prepared_, point, from_afar, next);
}

}  // namespace dewbow::walk
