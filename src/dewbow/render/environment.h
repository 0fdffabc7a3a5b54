// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from a picture of the surroundings: radiance by direction, spectra from its RGB, and
// sampling in proportion to its brightness.

#include "dewbow/math/distribution.h"
#include "dewbow/render/lanes.h"
#include "dewbow/scene/light.h"

namespace dewbow {

/// Seven smooth emission spectra — white, cyan, magenta, yellow, red, green, blue — of which every
/// colour of light is a mixture of at most three with weights >= 0; the mixture's XYZ is exactly
/// the colour's. [after Smits, "An RGB to Spectrum Conversion for Reflectances", 1999]
class RgbLightLanes {
public:
    /// Forgets everything: a new packet begins.
    void begin(const WavelengthPacket& packet) { packet_ = &packet, ready_ = false; }
    /// Spectral radiance of `rgb` (no negative channel) at each lane.
    void eval(Colour<LinearSrgb> rgb, const LaneSet& lanes, LaneValues& out);

private:
    const WavelengthPacket* packet_ = nullptr;
    bool ready_ = false;
    std::array<LaneValues, 7> basis_;
};

class EnvironmentMap {
public:
    explicit EnvironmentMap(std::shared_ptr<const ImageEnvironment> image);

    /// Radiance from `direction` (the way one looks), as colour: bilinear between pixels.
    Colour<LinearSrgb> radiance(Vec3 direction) const;
    struct Sample {
        Vec3 direction;
        double pdf;  ///< per steradian
    };
    Sample sample(std::array<double, 2> u) const;
    double pdf(Vec3 direction) const;
    /// Mean over the sphere of the radiance's Y.
    double mean_y() const { return mean_y_; }

private:
    struct Place {
        double x, y;  ///< in [0, 1)², from the top left
        double sin_theta;
    };
    Place place_of(Vec3 direction) const;

    std::shared_ptr<const ImageEnvironment> image_;
    Affine local_from_world_, world_from_local_;
    Distribution2D distribution_;
    double mean_y_ = 0.0;
};

}  // namespace dewbow
