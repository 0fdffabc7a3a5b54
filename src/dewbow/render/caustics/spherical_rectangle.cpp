// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow::caustics {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1

/// Solid angle of [0, x] × [0, y] at distance z, as a turn; negative where one of them is.
std::complex<double> corner(double x, double y, double z) {
    const double adjacent = z * std::sqrt(x * x + y * y + z * z), opposite = x * y;
    const double length = std::sqrt(adjacent * adjacent + opposite * opposite);
    return {adjacent / length, opposite / length};
}

/// a b* for what is finite: the language's product looks for infinities.
std::complex<double> turned_back(std::complex<double> a, std::complex<double> b) {
    return {a.real() * b.real() + a.imag() * b.imag(), a.imag() * b.real() - a.real() * b.imag()};
}

double sine_of(double opposite, double adjacent) {
    return opposite / std::sqrt(opposite * opposite + adjacent * adjacent);
}

/// From 0 to 2π: what is a little below 0 is so by rounding.
double solid_angle_of(std::complex<double> turn) {
    constexpr double kRounding = 1e-12;
    const double angle = std::arg(turn);
    return angle < -kRounding ? angle + 2.0 * std::numbers::pi : std::max(0.0, angle);
}

}  // namespace

SphericalRectangle::Turn SphericalRectangle::strip(double x) const {
    return turned_back(corner(x, y1_, z_), corner(x, y0_, z_));
}

SphericalRectangle::SphericalRectangle(double x0, double x1, double y0, double y1, double distance)
    : x0_(x0),
      x1_(x1),
      y0_(y0),
      y1_(y1),
      z_(distance),
      left_(strip(x0)),
      solid_angle_(solid_angle_of(turned_back(strip(x1), left_))) {}

/// x by the solid angle to its left. With b_i = y_i / sqrt(y_i² + z²) and s = x / sqrt(x² + z²) it
/// is T = asin(s b_1) − asin(s b_0), and so s = sin T / sqrt(b_0² + b_1² − 2 b_0 b_1 cos T).
/// Then y: on the great circle through x directions are alike in y / sqrt(x² + y² + z²).
SphericalRectangle::Point SphericalRectangle::sample(std::array<double, 2> u) const {
    const double b0 = sine_of(y0_, z_), b1 = sine_of(y1_, z_);
    const double t = std::arg(left_) + u[0] * solid_angle_;
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
    const double left = solid_angle_of(turned_back(strip(p.x), left_));
    const double d = std::hypot(p.x, z_);
    const double h0 = sine_of(y0_, d), h1 = sine_of(y1_, d);
    return {std::clamp(left / solid_angle_, 0.0, kOneBelow),
            std::clamp((sine_of(p.y, d) - h0) / (h1 - h0), 0.0, kOneBelow)};
}

}  // namespace dewbow::caustics
