// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a pixel to a ray, and from a point back to the film.

#include <array>
#include <optional>
#include <span>

#include "dewbow/base/random.h"
#include "dewbow/render/film.h"
#include "dewbow/render/pixel_filter.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/thin_lens.h"
#include "dewbow/scene/scene.h"
#include "dewbow/sky/polariser.h"

namespace dewbow {

/// How a point of the scene is seen: the inverse of a camera ray.
struct Seen {
    double x = 0.0, y = 0.0;  ///< on the film, in pixels from its top left corner
    Vec3 direction;           ///< from the point to the eye or to the point of the lens: unit
    double distance = 0.0;    ///< along it, m
    /// How densely the film sees there: pixels per m² of area that stands across the line of sight.
    /// A camera path of a picture of n pixels begins with the n-th part of it as its density.
    double pixels_per_m2 = 0.0;
    PixelRect frame;  ///< the pixels of the eye: a filter does not reach beyond
};

/// The remainder in [0, divisor).
constexpr int modulo(int value, int divisor) {
    const int remainder = value % divisor;
    return remainder < 0 ? remainder + divisor : remainder;
}

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

    /// Where the film sees `point` through the point `u_lens` of the lens (numbers as
    /// ThinLensOptics::sample takes them; without a lens they do not matter) at a wavelength: once,
    /// by each eye of a pair, or not at all. Whether anything stands between is not asked.
    ///
    /// Rays of ray() from the same point of the lens through (x, y) hit `point`. Points a little
    /// outside of the picture are told too, as far as the filter of a pixel reaches. A panorama
    /// sees each direction once, in [0, width) × [0, height]; its filter reaches over its edges.
    /// @return  how many of `out` are written.
    int seen(Vec3 point, std::array<double, 2> u_lens, double lambda_nm,
             std::array<Seen, 2>& out) const;
    /// Seen::pixels_per_m2 of `point`, on a camera ray that starts at `origin`.
    double pixels_per_m2(Vec3 origin, Vec3 point) const;
    /// Calls `add(x, y, weight)` for each pixel whose filter holds the film's point `at`, with the
    /// filter's density there, in pixels⁻²: so that splats at density 1 a pixel bring the mean that
    /// samples of ray() bring. A pixel of a panorama may be called more than once. A polariser
    /// takes its share of the weight.
    template <class Add>
    void for_each_pixel(const Seen& at, Add&& add) const;

    /// What the depth layer holds for a point, in m: along the axis from the camera's plane; of a
    /// panorama, the distance.
    double depth_of(Vec3 point) const;
    const std::optional<Polariser>& polariser() const { return polariser_; }
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
    bool see(Vec3 point, DiscPoint lens, double vergence, double eye, Seen& out) const;
    bool see_around(Vec3 point, Seen& out) const;
    PixelRect frame_of(bool right_eye) const;
    bool reaches_frame(const Seen& at) const;

    FilterSampler filter_;
    Projection projection_;
    std::optional<ThinLensOptics> lens_;
    std::optional<StereoPair> stereo_;
    std::optional<Polariser> polariser_;
    Transform<World, Camera> world_from_camera_;
    Vec3 position_, axis_;
    double half_width_ = 0.0, half_height_ = 0.0;  // perspective: at distance 1; else in m
    double width_, height_;                        // of one eye's picture, in pixels
    // Pixels by area of the plane at distance 1, or by angles of a panorama; by m² of the plane if
    // parallel. Over the volume that the camera's frame takes in the world.
    double film_scale_ = 0.0;
};

template <class Add>
void CameraRays::for_each_pixel(const Seen& at, Add&& add) const {
    const bool around = std::holds_alternative<Panorama>(projection_);
    const int columns = at.frame.width(), rows = at.frame.height();
    const double passes = polariser_ ? kPolariserShare : 1.0;
    filter_.for_each_cell(at.y, [&](int y, double weight_y) {
        // Beyond a pole the way goes on over it, half a turn away.
        int row = y;
        if (around) row = modulo(y, 2 * rows);
        const bool over = around && row >= rows;
        if (over) row = 2 * rows - 1 - row;
        if (row < at.frame.y0 || row >= at.frame.y1) return;
        filter_.for_each_cell(over ? at.x + 0.5 * columns : at.x, [&](int x, double weight_x) {
            const int column = around ? modulo(x, columns) : x;
            if (column >= at.frame.x0 && column < at.frame.x1)
                add(column, row, weight_x * weight_y * passes);
        });
    });
}

}  // namespace dewbow
