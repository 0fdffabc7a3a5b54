// SPDX-License-Identifier: Apache-2.0
//
// From a point of the scene to the film: the inverse of camera_ray.cpp.
//
// With P the point in the camera's frame, o where the ray starts, t the way along the axis and K
// the pixels of the film by area of the plane at distance 1, a cone of rays that is dx dy wide on
// the film is dx dy t² / K wide in the plane of P, and by cos θ = t / |P − o| less across the line
// of sight. A frame that is scaled in the world changes cross-sections by the determinant of its
// map and lengths along the ray by |M d|.
#include <cmath>
#include <numbers>

#include "dewbow/render/camera_ray.h"

namespace dewbow {

PixelRect CameraRays::frame_of(bool right_eye) const {
    const int width = int(width_), height = int(height_);
    int x0 = 0, y0 = 0;
    if (right_eye && stereo_->layout == StereoLayout::side_by_side) x0 = width;
    if (right_eye && stereo_->layout == StereoLayout::over_under) y0 = height;
    return {x0, y0, x0 + width, y0 + height};
}

/// Whether the filter of any pixel of the frame holds the point.
bool CameraRays::reaches_frame(const Seen& at) const {
    const double beyond = filter_.radius() - 0.5;
    return at.x >= at.frame.x0 - beyond && at.x <= at.frame.x1 + beyond &&
           at.y >= at.frame.y0 - beyond && at.y <= at.frame.y1 + beyond;
}

double CameraRays::pixels_per_m2(Vec3 origin, Vec3 point) const {
    const Vec3 way = point - origin;
    const Vec3 in_camera = world_from_camera_.inverse_affine().apply_linear(way);
    const double scale = film_scale_ * length(way);
    if (std::holds_alternative<Panorama>(projection_))  // 1 / (sin θ r³)
        return scale / (std::hypot(in_camera.x, in_camera.z) * dot(in_camera, in_camera));
    const double t = -in_camera.z;
    return std::holds_alternative<Orthographic>(projection_) ? scale / t : scale / (t * t * t);
}

bool CameraRays::see_around(Vec3 point, Seen& out) const {
    const Vec3 at = world_from_camera_.inverse_affine().apply(point);
    const double across = std::hypot(at.x, at.z);
    if (!(across > 0.0)) return false;  // a pole is a whole row of the picture
    out.frame = frame_of(false);
    out.x = width_ * (0.5 + std::atan2(at.x, -at.z) / (2.0 * std::numbers::pi));
    if (out.x >= width_) out.x = 0.0;
    out.y = height_ * std::atan2(across, at.y) / std::numbers::pi;
    out.distance = length(position_ - point);
    out.direction = (position_ - point) / out.distance;
    out.pixels_per_m2 = pixels_per_m2(position_, point);
    return true;
}

/// @param lens  the point of the lens, m.   @param eye  where along x the eye stands, m.
bool CameraRays::see(Vec3 point, DiscPoint lens, double vergence, double eye, Seen& out) const {
    const Vec3 at = world_from_camera_.inverse_affine().apply(point);
    const double t = -at.z;
    if (!(t > 0.0)) return false;
    const bool parallel = std::holds_alternative<Orthographic>(projection_);
    const Vec3 start = parallel ? Vec3{at.x, at.y, 0.0} : Vec3{eye + lens.x, lens.y, 0.0};
    // The chief ray through the film's point: that of the same direction as the eye's without an
    // offset, and as the lens's centre's.
    double across = at.x, up = at.y;
    if (!parallel) {
        across = (at.x - start.x) / t + lens.x * vergence;
        up = (at.y - start.y) / t + lens.y * vergence;
        if (stereo_) across += eye / stereo_->convergence.to(unit::m);
    }
    out.frame = frame_of(stereo_ && eye > 0.0);
    out.x = out.frame.x0 + 0.5 * width_ * (1.0 + across / half_width_);
    out.y = out.frame.y0 + 0.5 * height_ * (1.0 - up / half_height_);
    if (!reaches_frame(out)) return false;
    const Vec3 origin = world_from_camera_(Point<Camera>{start}).v;
    out.distance = length(origin - point);
    out.direction = (origin - point) / out.distance;
    out.pixels_per_m2 = pixels_per_m2(origin, point);
    return true;
}

int CameraRays::seen(Vec3 point, std::array<double, 2> u_lens, double lambda_nm,
                     std::array<Seen, 2>& out) const {
    if (std::holds_alternative<Panorama>(projection_)) return see_around(point, out[0]);
    DiscPoint lens{0.0, 0.0};
    double vergence = 0.0;
    if (lens_) {
        lens = lens_->sample(u_lens[0], u_lens[1]);
        lens_->vergences({&lambda_nm, 1}, {&vergence, 1});
    }
    if (!stereo_) return see(point, lens, vergence, 0.0, out[0]);
    const double half = 0.5 * stereo_->separation.to(unit::m);
    int count = 0;
    if (stereo_->layout != StereoLayout::right)
        count += see(point, lens, vergence, -half, out[std::size_t(count)]);
    if (stereo_->layout != StereoLayout::left)
        count += see(point, lens, vergence, half, out[std::size_t(count)]);
    return count;
}

}  // namespace dewbow
