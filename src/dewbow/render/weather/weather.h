// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the air of a scene holds between its bodies, where the surroundings are: rain. Rains lie on
// top of each other and add.

#include "dewbow/render/lanes.h"
#include "dewbow/render/weather/packet_weather.h"
#include "dewbow/render/weather/way.h"

namespace dewbow {

class Weather {
public:
    /// Whether a scene has any.
    static bool is_there(const Scene& scene);
    /// Of a scene that outlives it.
    explicit Weather(const Scene& scene);

    const std::vector<Rain>& rains() const { return rains_; }

    /// Multiplies `values` by what the weather leaves of light on `way`: an unbiased estimate of
    /// it where a rain is uneven, else exact.
    void dim(const Way& way, PacketWeather& packet, const LaneSet& lanes, const SampleKey& key,
             LaneValues& values) const;

private:
    const std::vector<Rain>& rains_;
};

}  // namespace dewbow
