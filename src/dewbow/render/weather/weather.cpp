// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/weather.h"

#include <cmath>

namespace dewbow {

namespace {

/// Length of the way that lies in a region, m.
double length_in(const ConvexRegion& region, const Way& way) {
    const std::optional<LineInterval> inside =
        region.cut({way.origin}, {way.direction}, way.length);
    return inside ? inside->end - inside->begin : 0.0;
}

}  // namespace

bool Weather::is_there(const Scene& scene) { return !scene.rains.empty(); }

Weather::Weather(const Scene& scene) : rains_(scene.rains) {}

void Weather::dim(const Way& way, PacketWeather& packet, const LaneSet& lanes, const SampleKey&,
                  LaneValues& values) const {
    for (std::size_t i = 0; i < rains_.size(); ++i) {
        const double length = length_in(std::get<ConvexRegion>(rains_[i].region), way);
        if (length == 0.0) continue;
        const PacketWeather::RainLanes& rain = packet.rain(i);
        for (int k = 0; k < lanes.count; ++k)
            values[k] *= std::exp(-rain.extinction[std::size_t(lanes.id[std::size_t(k)])] * length);
    }
}

}  // namespace dewbow
