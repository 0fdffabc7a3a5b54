// SPDX-License-Identifier: Apache-2.0
#include "next_event_walk.h"

namespace dewbow::bench {

void NextEventWalk::on_flight(const walk::SharedPath& path, const Hit& hit) {
    if (!in_weather(path.media)) return;
    const Way way = flight(path, hit);
    drops_.look(*prepared_.weather, packet_weather(), path.lanes, way);
    if (!(drops_.probability() > 0.0)) return;

    const std::array<double, 2> u = key_.two(way.at, Purpose::haze);
    const DropCollisions::Place place = drops_.sample(u[0]);
    const Vec3 point = way.origin + way.direction * place.distance;
    const std::optional<LightSample> light = prepared_.lights.sample(
        {point}, u[1], {key_.third(way.at, Purpose::haze), key_.fourth(way.at, Purpose::haze)});
    if (!light || !(light->pdf > 0.0)) return;
    if (prepared_.accelerator.occluded({point, light->direction, {}}, light->distance)) return;

    LaneValues radiance, scattered;
    prepared_.lights.radiance(*light, path.lanes, light_colours(), radiance);
    drops_.scattered(place.distance, dot(way.direction, light->direction), scattered);
    for (int k = 0; k < path.lanes.count; ++k) radiance[k] *= scattered[k];
    dim(shadow_way(point, light->direction, light->distance, way.at), path.lanes, radiance);
    dim({way.origin, way.direction, place.distance, way.at, Purpose::rain_on_flight}, path.lanes,
        radiance);
    add(path, radiance, 1.0 / (light->pdf * place.pdf));
}

}  // namespace dewbow::bench
