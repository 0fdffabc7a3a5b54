// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/camera_ray.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace dewbow {

namespace {

/// Cells of the table of a filter: its steps are 1/500 of the filter's width, far below what shows.
constexpr int kFilterCells = 500;

/// The filter at x in [−1, 1], unnormalised.
double filter_value(FilterKind kind, double x) {
    switch (kind) {
        case FilterKind::box:
            return 1.0;
        case FilterKind::gaussian:
            return std::exp(-0.5 * 9.0 * x * x);
        case FilterKind::blackman_harris: {
            // The four-term window. [Harris 1978, table 1: minimum side lobes, −92 dB]
            const double a = std::numbers::pi * (x + 1.0);
            return 0.35875 - 0.48829 * std::cos(a) + 0.14128 * std::cos(2.0 * a) -
                   0.01168 * std::cos(3.0 * a);
        }
    }
    return 0.0;
}

std::vector<double> filter_table(FilterKind kind) {
    std::vector<double> table;
    for (int i = 0; i < kFilterCells; ++i)
        table.push_back(filter_value(kind, 2.0 * (i + 0.5) / kFilterCells - 1.0));
    return table;
}

}  // namespace

FilterSampler::FilterSampler(const PixelFilter& filter)
    : radius_(filter.radius), density_(filter_table(filter.kind)) {}

double FilterSampler::sample(double u) const {
    const Distribution1D::Sample s = density_.sample(u);
    return radius_ * (2.0 * (double(s.index) + s.offset) / kFilterCells - 1.0);
}

CameraRays::CameraRays(const Scene& scene)
    : filter_(scene.film.filter),
      world_from_camera_(scene.camera.world_from_camera),
      position_(world_from_camera_(Point<Camera>{}).v),
      axis_(normalised(world_from_camera_(Dir<Camera>{{0, 0, -1}}).v)),
      half_height_(
          tan(0.5 * std::get<Perspective>(scene.camera.projection).vertical_field_of_view)),
      width_(scene.film.width),
      height_(scene.film.height) {
    half_width_ = half_height_ * width_ / height_;
}

Ray CameraRays::ray_through(double x, double y) const {
    const Vec3 d{half_width_ * (2.0 * x / width_ - 1.0), half_height_ * (1.0 - 2.0 * y / height_),
                 -1.0};
    return {position_, normalised(world_from_camera_(Dir<Camera>{d}).v), {}};
}

Ray CameraRays::ray(int x, int y, const SampleKey& key) const {
    const std::array<double, 2> u = key.two(0, Purpose::pixel_filter);
    return ray_through(x + 0.5 + filter_.sample(u[0]), y + 0.5 + filter_.sample(u[1]));
}

}  // namespace dewbow
