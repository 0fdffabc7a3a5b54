// SPDX-License-Identifier: Apache-2.0
//
// Aerial perspective: light that the clear air on a flight scatters towards its start.
#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

namespace {

/// Random numbers of it, beside those of the rain's own light.
constexpr std::uint32_t kAirBeforeRain = 0x165667b1u;

}  // namespace

/// Of a flight that meets something the air's light, as if rain on the flight stood before all of
/// it. A flight that meets nothing has it from the sky.
void CameraWalk::light_of_air(const SharedPath& path, const Hit& hit) {
    const Weather& weather = *prepared_.weather;
    const Way way = flight(path, hit);
    if (hit) {
        LaneValues light = weather.airlight(way, path.lanes);
        weather.dim_by_rain(way, packet_weather(), path.lanes, key_, light);
        add(path, light, 1.0);
    }
    if (!weather.rains().empty()) air_before_rain(path, way);
}

/// What the air sends from before the drops, which they do not dim. With A(s) the air's light from
/// as far as s, and P(s) the share of light from there that rain stops on the way,
/// $\int A'(1 - P)\,ds = A(1 - P)|_{end} + \int A\,dP$: the second term, at one point of the flight
/// that is taken in proportion to what the drops stop.
void CameraWalk::air_before_rain(const SharedPath& path, const Way& way) {
    const Weather& weather = *prepared_.weather;
    auto& [pieces, light, lanes] = rain_memory();
    pieces.cut(weather, way, nullptr);
    if (pieces.empty()) return;
    const int count = path.lanes.count;
    set_extinction_of_rains(path.lanes);
    for (RainLight::RainLanes& rain : lanes) rain.source = rain.extinction;
    light.weigh(pieces, lanes, {}, count);

    const std::uint32_t at = way.at + kAirBeforeRain;
    const auto sample = light.sample(key_.one(at, Purpose::rain_point));
    if (!sample) return;
    const Way before{way.origin, way.direction, sample->distance, at, Purpose::rain_on_flight};
    LaneValues sent = weather.airlight(before, path.lanes);
    if (!weather.uneven()) {
        for (int k = 0; k < count; ++k) sent[k] *= sample->source[k] * sample->left[k];
    } else {
        const Vec3 point = way.origin + way.direction * sample->distance;
        const auto there = pieces.rains(sample->piece);
        LaneValues stopped;
        stopped.v.fill(0.0);
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            if (!there[i].inside) continue;
            const double density = weather.density(i, point) / weather.usual_density(i);
            for (int k = 0; k < count; ++k) stopped[k] += lanes[i].extinction[k] * density;
        }
        for (int k = 0; k < count; ++k) sent[k] *= stopped[k];
        weather.dim_by_rain(before, packet_weather(), path.lanes, key_, sent);
    }
    add(path, sent, sample->metres);
}

}  // namespace dewbow::walk
