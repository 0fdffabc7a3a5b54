// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;

/// Between unit vectors, exact also near 0 and π, where the cosine says little.
double angle_between(Vec3 a, Vec3 b) { return 2.0 * std::atan2(length(a - b), length(a + b)); }

}  // namespace

DirectionCone DirectionCone::all() { return {{0.0, 0.0, 1.0}, kPi}; }

DirectionCone join(const DirectionCone& a, const DirectionCone& b) {
    const DirectionCone& wide = a.half_angle_rad >= b.half_angle_rad ? a : b;
    const DirectionCone& other = &wide == &a ? b : a;
    const double apart = angle_between(wide.axis, other.axis);
    if (apart + other.half_angle_rad <= wide.half_angle_rad) return wide;
    const double half = 0.5 * (wide.half_angle_rad + apart + other.half_angle_rad);
    if (half >= kPi) return DirectionCone::all();
    // The new axis lies in the plane of both, so that it reaches as far on either side.
    const Vec3 aside = other.axis - wide.axis * dot(wide.axis, other.axis);
    if (!(dot(aside, aside) > 0.0)) return DirectionCone::all();
    const double turn = half - wide.half_angle_rad;
    const Vec3 axis = wide.axis * std::cos(turn) + normalised(aside) * std::sin(turn);
    return {normalised(axis), half};
}

LightBounds join(const LightBounds& a, const LightBounds& b) {
    if (!(a.intensity > 0.0)) return b;
    if (!(b.intensity > 0.0)) return a;
    LightBounds both = a;
    both.box.add(b.box.low);
    both.box.add(b.box.high);
    both.intensity = a.intensity + b.intensity;
    both.normals = join(a.normals, b.normals);
    both.emission_rad = std::max(a.emission_rad, b.emission_rad);
    both.two_sided = a.two_sided || b.two_sided;
    return both;
}

double emission_measure(const LightBounds& bounds) {
    // 2π [∫₀^θo sin θ dθ + ∫_θo^θw cos(θ − θo) sin θ dθ], the second integral in closed form.
    const double normals = bounds.normals.half_angle_rad;
    const double end = std::min(normals + bounds.emission_rad, kPi);
    const double inside = 2.0 * kPi * (1.0 - std::cos(normals));
    const double around = kPi / 2.0 *
                          (2.0 * (end - normals) * std::sin(normals) -
                           std::cos(2.0 * end - normals) + std::cos(normals));
    return (inside + around) * (bounds.two_sided ? 2.0 : 1.0);
}

}  // namespace dewbow
