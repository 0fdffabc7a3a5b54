// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rains and suns at the wavelengths of one packet, computed when first asked for.

#include <span>
#include <vector>

#include "dewbow/render/weather/rain_sun.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

class PacketWeather {
public:
    /// A new packet begins in a scene with these rains and suns, which outlive its use.
    void begin(std::span<const Rain> rains, std::span<const RainSun> suns,
               const WavelengthPacket& packet);

    struct RainLanes {
        std::uint64_t generation = 0;  ///< of the packet
        /// m⁻¹ where the rain's density is 1, and the share of it that is scattered; at each lane
        /// of the packet.
        alignas(64) std::array<double, kMaxLanes> extinction, albedo;
    };
    /// Of the scene's rain with this index.
    const RainLanes& rain(std::size_t index) {
        RainLanes& lanes = rain_lanes_[index];
        if (lanes.generation != generation_) fill(lanes, *rains_[index].drops);
        return lanes;
    }

    /// Irradiance of the weather's sun with this index, W m⁻² nm⁻¹ at each lane of the packet.
    const std::array<double, kMaxLanes>& sun(std::size_t index) {
        SunLanes& lanes = sun_lanes_[index];
        if (lanes.generation != generation_) fill(lanes, *suns_[index].irradiance);
        return lanes.irradiance;
    }

private:
    struct SunLanes {
        std::uint64_t generation = 0;
        alignas(64) std::array<double, kMaxLanes> irradiance;
    };
    void fill(SunLanes& lanes, const Spectrum& irradiance) const;
    void fill(RainLanes& lanes, const DropCloud& drops) const;

    std::span<const Rain> rains_;
    std::span<const RainSun> suns_;
    std::vector<RainLanes> rain_lanes_;
    std::vector<SunLanes> sun_lanes_;
    WavelengthPacket packet_;
    std::uint64_t generation_ = 0;
};

}  // namespace dewbow
