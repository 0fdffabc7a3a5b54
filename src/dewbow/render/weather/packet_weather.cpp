// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/packet_weather.h"

#include "dewbow/sky/drop_cloud.h"

namespace dewbow {

void PacketWeather::begin(std::span<const Rain> rains, std::span<const RainSun> suns,
                          const WavelengthPacket& packet) {
    rains_ = rains, suns_ = suns;
    rain_lanes_.resize(rains.size());
    sun_lanes_.resize(suns.size());
    packet_ = packet;
    ++generation_;
}

void PacketWeather::fill(RainLanes& lanes, const DropCloud& drops) const {
    lanes.generation = generation_;
    const auto lambdas = packet_.lambdas();
    drops.extinction_lanes(lambdas, std::span(lanes.extinction).first(lambdas.size()));
    drops.albedo_lanes(lambdas, std::span(lanes.albedo).first(lambdas.size()));
}

void PacketWeather::fill(SunLanes& lanes, const Spectrum& irradiance) const {
    lanes.generation = generation_;
    const auto lambdas = packet_.lambdas();
    irradiance.eval_lanes(lambdas, std::span(lanes.irradiance).first(lambdas.size()));
}

}  // namespace dewbow
