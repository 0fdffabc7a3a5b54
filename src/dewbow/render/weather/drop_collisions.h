// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where a path in rain meets a drop, and where to the drop turns it: for light that is scattered
// more than once.

#include <optional>
#include <vector>

#include "dewbow/render/weather/weather.h"

namespace dewbow {

/// The drops that a packet may meet on a straight way. One distance is taken for all lanes, with
/// the mean of the densities with which each alone would meet a drop, σ_k e^(−τ_k); one direction
/// with a density that is that of white light. Rains count as if they were everywhere as dense as
/// where they are densest; what is not there is weighed out by turn() and scattered().
class DropCollisions {
public:
    /// Of a new way; what was there before is forgotten. What is given must outlive the questions.
    void look(const Weather& weather, PacketWeather& packet, const LaneSet& lanes, const Way& way);

    /// Mean over the lanes of the probability to meet a drop on the way; 0: no rain is there.
    double probability() const { return probability_; }
    struct Place {
        double distance;  ///< m
        double pdf;       ///< per metre: its integral over the way is 1
    };
    /// @param u  in [0, 1).   Asked for only where probability() > 0.
    Place sample(double u) const;

    /// What drops at a distance scatter of light that comes along a ray, per m and sr, by the
    /// cosine of the angle between its directions before and after.
    void scattered(double distance, double cosine, LaneValues& out) const;

    struct Turn {
        Vec3 direction;  ///< unit
        double pdf;      ///< per sr
        LaneValues scattered;
    };
    /// Of what comes along the way, at a distance.   @param u_rain, u  in [0, 1).
    /// Nothing where it does not rain.
    std::optional<Turn> turn(double distance, double u_rain, std::array<double, 2> u) const;

private:
    struct Crossing {
        LineInterval inside;
        std::size_t rain;
        const PacketWeather::RainLanes* lanes;
    };
    /// On which the same rains fall.
    struct Stretch {
        double begin, end;
        LaneValues extinction, depth;  ///< m⁻¹; optical depth at the begin
    };
    const DropCloud& drops(const Crossing& crossing) const;
    const Stretch& stretch_at(double distance) const;
    double distance_at(int lane, double depth) const;
    double scattering(const Crossing& crossing, int lane) const;
    /// Calls `f(crossing, density)` for each rain that falls there.
    template <class F>
    void for_each_at(double distance, F&& f) const;
    double brightness(const Crossing& crossing) const;

    const Weather* weather_ = nullptr;
    Vec3 origin_, direction_;
    LaneSet lanes_;
    std::vector<LineInterval> inside_;
    std::vector<Crossing> crossings_;
    std::vector<double> ends_;
    std::vector<Stretch> stretches_;
    LaneValues opacity_;  ///< of the whole way
    double probability_ = 0.0;
};

}  // namespace dewbow
