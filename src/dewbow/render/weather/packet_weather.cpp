// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/packet_weather.h"

#include "dewbow/sky/drop_cloud.h"

namespace dewbow {

void PacketWeather::begin(std::span<const Rain> rains, const WavelengthPacket& packet) {
    rains_ = rains;
    entries_.resize(rains.size());
    packet_ = packet;
    ++generation_;
}

void PacketWeather::fill(RainLanes& lanes, const DropCloud& drops) const {
    lanes.generation = generation_;
    const auto lambdas = packet_.lambdas();
    drops.extinction_lanes(lambdas, std::span(lanes.extinction).first(lambdas.size()));
    drops.albedo_lanes(lambdas, std::span(lanes.albedo).first(lambdas.size()));
}

}  // namespace dewbow
