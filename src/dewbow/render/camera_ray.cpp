// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/camera_ray.h"

#include <cmath>
#include <numbers>

namespace dewbow {

CameraRays::CameraRays(const Scene& scene)
    : filter_(scene.film.filter),
      projection_(scene.camera.projection),
      stereo_(scene.camera.stereo),
      world_from_camera_(scene.camera.world_from_camera),
      position_(world_from_camera_(Point<Camera>{}).v),
      axis_(normalised(world_from_camera_(Dir<Camera>{{0, 0, -1}}).v)),
      width_(scene.film.width),
      height_(scene.film.height) {
    if (scene.camera.lens) lens_.emplace(*scene.camera.lens);
    if (scene.camera.polariser)
        polariser_.emplace(*scene.camera.polariser, world_from_camera_,
                           std::holds_alternative<Panorama>(projection_));
    if (stereo_ && stereo_->layout == StereoLayout::side_by_side) width_ /= 2.0;
    if (stereo_ && stereo_->layout == StereoLayout::over_under) height_ /= 2.0;
    if (const auto* perspective = std::get_if<Perspective>(&projection_))
        half_height_ = tan(0.5 * perspective->vertical_field_of_view);
    if (const auto* orthographic = std::get_if<Orthographic>(&projection_))
        half_height_ = 0.5 * orthographic->height.to(unit::m);
    half_width_ = half_height_ * width_ / height_;
    const double area = std::holds_alternative<Panorama>(projection_)
                            ? 2.0 * std::numbers::pi * std::numbers::pi
                            : 4.0 * half_width_ * half_height_;
    film_scale_ =
        width_ * height_ / (area * std::abs(scene.camera.world_from_camera.affine().determinant()));
}

/// The chief ray through (x, y), a point in the picture of the eye that sees pixel (px, py).
CameraRays::Chief CameraRays::chief_through(double x, double y, int px, int py) const {
    if (std::holds_alternative<Panorama>(projection_)) {
        // Beyond a pole the sine is negative: the way over it, as it should be.
        const double theta = std::numbers::pi * y / height_;
        const double phi = 2.0 * std::numbers::pi * (x / width_ - 0.5);
        const double sine = std::sin(theta);
        return {{}, {sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi)}};
    }
    const double eye = stereo_ ? eye_of(px, py) : 0.0;
    if (eye > 0.0 && stereo_->layout == StereoLayout::side_by_side) x -= width_;
    if (eye > 0.0 && stereo_->layout == StereoLayout::over_under) y -= height_;
    const double across = half_width_ * (2.0 * x / width_ - 1.0),
                 up = half_height_ * (1.0 - 2.0 * y / height_);
    if (std::holds_alternative<Orthographic>(projection_)) return {{across, up, 0}, {0, 0, -1}};
    if (!stereo_) return {{}, {across, up, -1.0}};
    // Through the same point of the plane of convergence as without the offset.
    return {{eye, 0, 0}, {across - eye / stereo_->convergence.to(unit::m), up, -1.0}};
}

/// Where along x the eye stands whose picture holds pixel (px, py), in m.
double CameraRays::eye_of(int px, int py) const {
    bool right = stereo_->layout == StereoLayout::right;
    if (stereo_->layout == StereoLayout::side_by_side) right = px >= width_;
    if (stereo_->layout == StereoLayout::over_under) right = py >= height_;
    return (right ? 0.5 : -0.5) * stereo_->separation.to(unit::m);
}

CameraRays::Chief CameraRays::chief(int x, int y, const SampleKey& key) const {
    const std::array<double, 2> u = key.two(0, Purpose::pixel_filter);
    return chief_through(x + 0.5 + filter_.sample(u[0]), y + 0.5 + filter_.sample(u[1]), x, y);
}

Ray CameraRays::ray_along(const Chief& chief) const {
    const Vec3 origin =
        chief.origin == Vec3{} ? position_ : world_from_camera_(Point<Camera>{chief.origin}).v;
    return {origin, normalised(world_from_camera_(Dir<Camera>{chief.direction}).v), {}};
}

/// From the point `p` of the lens instead of its centre, to where both rays meet.
CameraRays::Chief CameraRays::through_lens(const Chief& chief, DiscPoint p, double vergence) {
    const Vec3 offset{p.x, p.y, 0.0};
    return {chief.origin + offset, chief.direction - offset * vergence};
}

DiscPoint CameraRays::on_lens(const SampleKey& key) const {
    const std::array<double, 2> u = key.two(0, Purpose::lens);
    return lens_->sample(u[0], u[1]);
}

Ray CameraRays::ray_through(double x, double y) const {
    return ray_along(chief_through(x, y, int(x), int(y)));
}

Ray CameraRays::ray(int x, int y, const SampleKey& key) const {
    const Chief line = chief(x, y, key);
    return ray_along(lens_ ? through_lens(line, on_lens(key), lens_->vergence()) : line);
}

RayLanes CameraRays::rays(int x, int y, const SampleKey& key,
                          std::span<const double> lambda_nm) const {
    const Chief line = chief(x, y, key);
    const DiscPoint p = on_lens(key);
    std::array<double, kMaxLanes> vergence;
    lens_->vergences(lambda_nm, vergence);
    RayLanes rays;
    rays.count = int(lambda_nm.size());
    for (int k = 0; k < rays.count; ++k)
        rays.set(k, ray_along(through_lens(line, p, vergence[std::size_t(k)])));
    return rays;
}

double CameraRays::depth_of(Vec3 point) const {
    const Vec3 to = point - position_;
    return std::holds_alternative<Panorama>(projection_) ? length(to) : dot(to, axis_);
}

}  // namespace dewbow
