// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "dewbow/render/media.h"
#include "dewbow/render/prepared_scene.h"
#include "dewbow/render/rgb_lanes.h"
#include "dewbow/render/walk/packet_path.h"
#include "dewbow/render/weather/drop_collisions.h"
#include "dewbow/render/weather/rain_light.h"

namespace dewbow::walk {

/// For the rain of one flight at a time.
struct RainMemory {
    FlightPieces pieces;
    RainLight light;
    std::vector<RainLight::RainLanes> lanes;  ///< one a rain of the scene
};

/// Memory that one thread needs for its packets, kept between samples.
struct WalkMemory {
    std::uint64_t serial = 0;
    std::optional<PacketMedia> media;
    PacketWeather weather;
    DropCollisions drops;
    RainMemory rain;
    // Spectra of RGB colours at the packet's wavelengths.
    RgbLightLanes light;
    RgbReflectanceLanes reflectance;
    std::vector<SharedPath> pending;  ///< single lanes that go on from something rough
};

/// This thread's, for a new packet in `prepared`. One walk uses it at a time.
WalkMemory& walk_memory(const PreparedScene& prepared, const WavelengthPacket& packet);

}  // namespace dewbow::walk
