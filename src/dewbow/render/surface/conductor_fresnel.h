// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/lanes.h"
#include "dewbow/scene/material.h"

namespace dewbow {

/// Fresnel's reflectance of a metal at the lanes of a path.
class ConductorFresnel {
public:
    /// @param outside  index of the medium in front, against vacuum, at each lane.
    ConductorFresnel(const Conductor& metal, const LaneSet& lanes, const LaneValues& outside);

    /// Unpolarised, at an angle of incidence with that cosine in [0, 1].
    void at(double cosine, LaneValues& reflectance) const;
    /// 2 ∫ F μ dμ by Gauss's rule with 3 nodes in μ². Error: kAverageFresnelError, for every metal
    /// of the catalogue (conductor_fresnel_test.cpp).
    void average(LaneValues& reflectance) const;

private:
    int count_;
    LaneValues n_, k_;  // against the medium in front
};

inline constexpr double kAverageFresnelError = 7e-3;

}  // namespace dewbow
