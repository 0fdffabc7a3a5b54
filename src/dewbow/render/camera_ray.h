// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a pixel to a ray.

#include "dewbow/base/random.h"
#include "dewbow/math/distribution.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/thin_lens.h"
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
    /// The ray of sample `key` through pixel (x, y), counted from the top left. Where wavelengths
    /// go different ways, that of the d line.
    Ray ray(int x, int y, const SampleKey& key) const;
    /// The ray through a point of the picture, in pixels from its top left corner, and through the
    /// centre of the lens.
    Ray ray_through(double x, double y) const;

    /// Whether each wavelength has a ray of its own.
    bool disperses() const { return lens_ && lens_->disperses(); }
    /// The rays of sample `key` if disperses(): all from one point of the lens, whose density does
    /// not depend on wavelength.
    RayLanes rays(int x, int y, const SampleKey& key, std::span<const double> lambda_nm) const;

    /// What the depth layer holds for a point, in m: along the axis from the camera's plane; of a
    /// panorama, the distance.
    double depth_of(Vec3 point) const;
    /// Unit vector straight ahead.
    Vec3 axis() const { return axis_; }
    /// The middle between the eyes of a pair; the middle of an orthographic picture's plane.
    Vec3 position() const { return position_; }

private:
    /// Through the centre of the lens. In the camera's frame; the direction is not of unit length.
    struct Chief {
        Vec3 origin, direction;
    };
    Chief chief_through(double x, double y, int px, int py) const;
    Chief chief(int x, int y, const SampleKey& key) const;
    double eye_of(int px, int py) const;
    static Chief through_lens(const Chief& chief, DiscPoint p, double vergence);
    DiscPoint on_lens(const SampleKey& key) const;
    Ray ray_along(const Chief& chief) const;

    FilterSampler filter_;
    Projection projection_;
    std::optional<ThinLensOptics> lens_;
    std::optional<StereoPair> stereo_;
    Transform<World, Camera> world_from_camera_;
    Vec3 position_, axis_;
    double half_width_ = 0.0, half_height_ = 0.0;  // perspective: at distance 1; else in m
    double width_, height_;                        // of one eye's picture, in pixels
};

}  // namespace dewbow
