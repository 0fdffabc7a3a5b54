// SPDX-License-Identifier: Apache-2.0
#pragma once

// A dome of sky light that is sampled in proportion to its luminance, above the horizon and below.

#include <optional>

#include "dewbow/math/distribution.h"
#include "dewbow/sky/sky_dome.h"

namespace dewbow {

class SkyMap {
public:
    explicit SkyMap(SkyDomePtr sky);

    const SkyDome& sky() const { return *sky_; }
    struct Sample {
        Vec3 direction;
        double pdf;  ///< per steradian
    };
    std::optional<Sample> sample(std::array<double, 2> u) const;
    double pdf(Vec3 direction) const;
    /// The numbers by which sample() takes `direction`.
    std::array<double, 2> place_of(Vec3 direction) const;
    /// Y of the radiance, 1 for the constant spectrum 1.
    double brightness(Vec3 direction) const;
    /// Mean of it over the sphere.
    double mean_brightness() const { return mean_brightness_; }

private:
    SkyDomePtr sky_;
    Distribution2D distribution_;
    double mean_brightness_ = 0.0;
};

}  // namespace dewbow
