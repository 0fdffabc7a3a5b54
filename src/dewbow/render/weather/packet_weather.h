// SPDX-License-Identifier: Apache-2.0
#pragma once

// What each rain does to the wavelengths of one packet, computed when first asked for.

#include <span>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow {

class PacketWeather {
public:
    /// A new packet begins in a scene with these rains, which outlive its use.
    void begin(std::span<const Rain> rains, const WavelengthPacket& packet);

    struct RainLanes {
        std::uint64_t generation = 0;
        /// m⁻¹ where the rain's density is 1, and the share of it that is scattered; at each lane
        /// of the packet.
        alignas(64) std::array<double, kMaxLanes> extinction, albedo;
    };
    /// Of the scene's rain with this index.
    const RainLanes& rain(std::size_t index) {
        RainLanes& lanes = entries_[index];
        if (lanes.generation != generation_) fill(lanes, *rains_[index].drops);
        return lanes;
    }

private:
    void fill(RainLanes& lanes, const DropCloud& drops) const;

    std::span<const Rain> rains_;
    std::vector<RainLanes> entries_;
    WavelengthPacket packet_;
    std::uint64_t generation_ = 0;
};

}  // namespace dewbow
