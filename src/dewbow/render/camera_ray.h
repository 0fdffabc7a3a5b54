// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a pixel to a ray.

#include "dewbow/base/random.h"
#include "dewbow/math/distribution.h"
#include "dewbow/render/ray.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// Offsets from a pixel's centre, in proportion to the pixel filter (separable, so one axis a
/// time).
class FilterSampler {
public:
    explicit FilterSampler(const PixelFilter& filter);
    /// An offset in pixels, in [−radius, radius].
    double sample(double u) const;

private:
    double radius_;
    Distribution1D density_;
};

class CameraRays {
public:
    explicit CameraRays(const Scene& scene);
    /// The ray of sample `key` through pixel (x, y), counted from the top left.
    Ray ray(int x, int y, const SampleKey& key) const;
    /// The ray through a point of the picture, in pixels from its top left corner.
    Ray ray_through(double x, double y) const;
    /// Unit vector along which depth is measured.
    Vec3 axis() const { return axis_; }
    Vec3 position() const { return position_; }

private:
    FilterSampler filter_;
    Transform<World, Camera> world_from_camera_;
    Vec3 position_, axis_;
    double half_width_, half_height_;  // of the picture at distance 1
    double width_, height_;            // in pixels
};

}  // namespace dewbow
