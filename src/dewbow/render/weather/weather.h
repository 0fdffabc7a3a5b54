// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the air of a scene holds between its bodies, where the surroundings are: rain, the suns that
// make bows in it, and the air itself. Rains lie on top of each other and add.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/render/lanes.h"
#include "dewbow/render/weather/packet_weather.h"
#include "dewbow/render/weather/rain_sun.h"
#include "dewbow/render/weather/way.h"
#include "dewbow/scene/rain_inside.h"

namespace dewbow {

class Weather {
public:
    /// Whether a scene has any.
    static bool is_there(const Scene& scene);
    /// Of a scene that outlives it.   Throws InputError: drops that do not know a sun's disc.
    explicit Weather(const Scene& scene);

    std::span<const Rain> rains() const { return rains_; }
    /// The scene's distant lights, in its order, and then what level mirrors show of them. Where
    /// orders of light in rain above the first are looked for, those images are left out: paths
    /// that drops have turned find them.
    std::span<const RainSun> suns() const { return suns_; }
    /// Whether any rain's density changes from place to place.
    bool uneven() const { return uneven_; }
    /// About the mean of what density() is in the i-th rain, above 0; 1 if that is even.
    double usual_density(std::size_t rain) const { return usual_density_[rain]; }
    /// By what share of its full density the i-th rain falls at a point inside, 0 to 1.
    double density(std::size_t rain, Vec3 point) const;

    /// Where the i-th rain is on `way`, and how far it is in it towards a light.
    void cut(std::size_t rain, const Way& way, std::vector<LineInterval>& inside) const;
    void lengths_towards(std::size_t rain, const Way& way, LineInterval on, const RainSun& sun,
                         std::vector<LengthPiece>& pieces) const;

    /// Multiplies `values` by what the weather leaves of light on `way`: an unbiased estimate of
    /// it where a rain is uneven, else exact.
    void dim(const Way& way, PacketWeather& packet, const LaneSet& lanes, const SampleKey& key,
             LaneValues& values) const {
        dim_by_air(way, lanes, values);
        dim_by_rain(way, packet, lanes, key, values);
    }
    /// The rain's part of it, and the air's. Light from infinitely far is given as it arrives near
    /// the ground, so that air takes nothing from a way that has no end.
    void dim_by_rain(const Way& way, PacketWeather& packet, const LaneSet& lanes,
                     const SampleKey& key, LaneValues& values) const;
    void dim_by_air(const Way& way, const LaneSet& lanes, LaneValues& values) const;

    /// Whether the air between things is seen.
    bool has_air() const { return air_ != nullptr; }
    /// What air on a way of finite length scatters towards its origin, W m⁻² sr⁻¹ nm⁻¹.
    LaneValues airlight(const Way& way, const LaneSet& lanes) const;

private:
    void add_images(const Scene& scene);
    double length_that_dims(std::size_t rain, const Way& way) const;
    void dim_uneven(std::size_t rain, const Way& way, const PacketWeather::RainLanes& drops,
                    const LaneSet& lanes, const SampleKey& key, LaneValues& values) const;

    const Aerial* air_;
    std::span<const Rain> rains_;
    std::vector<RainInside> inside_;     ///< one a rain
    std::vector<double> usual_density_;  ///< one a rain
    std::vector<RainSun> suns_;
    bool uneven_ = false;
};

}  // namespace dewbow
