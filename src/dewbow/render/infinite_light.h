// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from infinitely far: the sun, the sky, a picture of the surroundings.

#include <optional>

#include "dewbow/render/environment.h"
#include "dewbow/render/rgb_lanes.h"
#include "dewbow/render/sky_map.h"

namespace dewbow {

/// A DistantLight, UniformEnvironment, ImageEnvironment or SkyDome.
class InfiniteLight {
public:
    static bool holds(const Light& light);
    explicit InfiniteLight(const Light& light);

    /// Parallel light has no extent: it is found by sampling alone.
    bool parallel() const { return kind_ == Kind::parallel; }
    /// Whether it is a DistantLight: as small as a sun, or without extent.
    bool distant() const { return kind_ == Kind::parallel || kind_ == Kind::disc; }
    /// Brightness of the irradiance that it gives, about.
    double irradiance() const { return irradiance_; }

    struct Sample {
        Vec3 direction;  ///< towards the light
        double pdf;      ///< per steradian; 1 for parallel light
    };
    std::optional<Sample> sample(std::array<double, 2> u) const;
    /// Per steradian, with which sample() takes `direction`; 0 for parallel light.
    double pdf(Vec3 direction) const;
    /// The numbers by which sample() takes a `direction` in which it shows.
    std::array<double, 2> place_of(Vec3 direction) const;
    /// Y of radiance(), white 1.
    double brightness(Vec3 direction) const;
    /// Whether a ray along `direction` that meets nothing sees it.
    bool shows(Vec3 direction) const;
    /// Radiance along a `direction` in which it shows; of parallel light the irradiance on a
    /// surface that faces it.
    void radiance(Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb, LaneValues& out) const;

private:
    enum class Kind { parallel, disc, even, picture, sky };
    Kind kind_;
    SpectrumPtr spectrum_;
    double factor_ = 1.0;  ///< from the spectrum to radiance
    double irradiance_ = 0.0;
    Vec3 axis_;                ///< towards a distant light
    double cone_width_ = 0.0;  ///< 1 − cos of its half angle
    std::optional<EnvironmentMap> map_;
    std::optional<SkyMap> sky_;
};

}  // namespace dewbow
