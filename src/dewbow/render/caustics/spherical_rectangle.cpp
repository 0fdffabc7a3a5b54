// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace dewbow::caustics {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1

/// Solid angle of [0, x] × [0, y] at distance z, negative where one of them is.
double corner(double x, double y, double z) {
    return std::atan2(x * y, z * std::sqrt(x * x + y * y + z * z));
}

double sine_of(double opposite, double adjacent) {
    return opposite / std::sqrt(opposite * opposite + adjacent * adjacent);
}

double strip(double x, double y0, double y1, double z) {
    return corner(x, y1, z) - corner(x, y0, z);
}

}  // namespace

SphericalRectangle::SphericalRectangle(double x0, double x1, double y0, double y1, double distance)
    : x0_(x0), x1_(x1), y0_(y0), y1_(y1), z_(distance) {
    solid_angle_ = strip(x1, y0, y1, z_) - strip(x0, y0, y1, z_);
}

/// x by the solid angle to its left. With b_i = y_i / sqrt(y_i² + z²) and s = x / sqrt(x² + z²) it
/// is T = asin(s b_1) − asin(s b_0), and so s = sin T / sqrt(b_0² + b_1² − 2 b_0 b_1 cos T).
/// Then y: on the great circle through x directions are alike in y / sqrt(x² + y² + z²).
SphericalRectangle::Point SphericalRectangle::sample(std::array<double, 2> u) const {
    const double b0 = sine_of(y0_, z_), b1 = sine_of(y1_, z_);
    const double t = strip(x0_, y0_, y1_, z_) + u[0] * solid_angle_;
    const double half = std::sin(0.5 * t);
    const double wide = std::sqrt((b1 - b0) * (b1 - b0) + 4.0 * b0 * b1 * half * half);
    const double s = std::clamp(std::sin(t) / wide, -kOneBelow, kOneBelow);
    const double x = std::clamp(z_ * s / std::sqrt((1.0 - s) * (1.0 + s)), x0_, x1_);
    const double d = std::hypot(x, z_);
    const double h0 = sine_of(y0_, d), h1 = sine_of(y1_, d);
    const double h = std::clamp(h0 + u[1] * (h1 - h0), -kOneBelow, kOneBelow);
    return {x, std::clamp(d * h / std::sqrt((1.0 - h) * (1.0 + h)), y0_, y1_)};
}

std::array<double, 2> SphericalRectangle::place_of(Point p) const {
    const double left = strip(p.x, y0_, y1_, z_) - strip(x0_, y0_, y1_, z_);
    const double d = std::hypot(p.x, z_);
    const double h0 = sine_of(y0_, d), h1 = sine_of(y1_, d);
    return {std::clamp(left / solid_angle_, 0.0, kOneBelow),
            std::clamp((sine_of(p.y, d) - h0) / (h1 - h0), 0.0, kOneBelow)};
}

}  // namespace dewbow::caustics
