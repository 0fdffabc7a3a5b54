// SPDX-License-Identifier: Apache-2.0
#pragma once

// The camera as a lit ray through haze looks at it.

#include <optional>

#include "dewbow/render/camera_ray.h"
#include "dewbow/render/haze/distance_density.h"

namespace dewbow {

class HazeView {
public:
    HazeView(const CameraView& view, const Film& film, const CameraRays& camera);

    /// Of the ray from `origin` along the unit vector `direction`, the part `where`: about in
    /// proportion to what the film sees of it, alike for each pixel.   @param extinction  m⁻¹, one
    /// a lane.
    DistanceDensity density(Vec3 origin, Vec3 direction, RayInterval where,
                            std::span<const double> extinction) const;

private:
    RayInterval seen_part(Vec3 origin, Vec3 direction) const;

    Vec3 eye_, axis_;
    double cosine_ = -1.0;          ///< of a cone that holds the picture; below 0: all around
    std::optional<double> radius_;  ///< of a cylinder that does, m: rays are parallel
};

}  // namespace dewbow
