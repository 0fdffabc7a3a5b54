// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from a picture of the surroundings: radiance by direction, and sampling in proportion to
// its brightness.

#include "dewbow/math/distribution.h"
#include "dewbow/render/equirectangular.h"
#include "dewbow/scene/light.h"

namespace dewbow {

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
    /// The numbers by which sample() takes `direction`.
    std::array<double, 2> place_of(Vec3 direction) const;
    /// Mean over the sphere of the radiance's Y.
    double mean_y() const { return mean_y_; }

private:
    EquirectangularPlace look_up(Vec3 direction) const;

    std::shared_ptr<const ImageEnvironment> image_;
    Affine local_from_world_, world_from_local_;
    Distribution2D distribution_;
    double mean_y_ = 0.0;
};

}  // namespace dewbow
