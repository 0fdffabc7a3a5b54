// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is left of light behind rain whose density changes from place to place, without bias.

#include <functional>
#include <span>

#include "dewbow/base/random.h"
#include "dewbow/render/lanes.h"
#include "dewbow/sky/rain_region.h"

namespace dewbow {

/// As many numbers as are asked for, of one vertex and purpose.
class RandomSteps {
public:
    RandomSteps(const SampleKey& key, std::uint32_t vertex, Purpose purpose)
        : key_(key), vertex_(vertex), purpose_(purpose) {}
    std::array<double, 2> next() { return key_.two(vertex_ + 0x85ebca6bu * ++step_, purpose_); }

private:
    const SampleKey& key_;
    std::uint32_t vertex_, step_ = 0;
    Purpose purpose_;
};

/// Multiplies lane k by an estimate of exp(−∫ extinction_k density ds) over `part` of a line, with
/// density 0 to 1: what even rain of the density `usual` leaves, and at random points, one in
/// 1 / (extinction · max(usual, 1 − usual)) m on average, what the true density makes of that.
/// No estimate is negative.
/// [Novák, Selle & Jarosz, "Residual Ratio Tracking for Estimating Attenuation in Participating
/// Media", ACM TOG 33(6), 2014, eq. 18]
void dim_by_uneven_rain(const LineInterval& part, std::span<const double> extinction, double usual,
                        const std::function<double(double)>& density, RandomSteps& steps,
                        LaneValues& values);

}  // namespace dewbow
