// SPDX-License-Identifier: Apache-2.0
#pragma once

// Directions as places of an equirectangular picture: row 0 is straight up (+y), the centre is −z,
// and longitude grows to the right, towards +x.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/vector.h"

namespace dewbow {

struct EquirectangularPlace {
    double x, y;  ///< in [0, 1)², from the top left
    double sin_theta;
};

/// @param direction  that one looks along, of unit length.
inline EquirectangularPlace equirectangular_from_direction(Vec3 direction) {
    constexpr double kPi = std::numbers::pi;
    const double theta = std::acos(std::clamp(direction.y, -1.0, 1.0));
    const double x = 0.5 + std::atan2(direction.x, -direction.z) / (2.0 * kPi);
    return {x >= 1.0 ? x - 1.0 : x, std::min(theta / kPi, 1.0 - 0x1p-53), std::sin(theta)};
}

inline Vec3 direction_from_equirectangular(double x, double y) {
    constexpr double kPi = std::numbers::pi;
    const double theta = kPi * y, phi = 2.0 * kPi * (x - 0.5), sine = std::sin(theta);
    return {sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi)};
}

/// Density per steradian of a density on [0, 1)² at a place; 0 at the poles.
inline double pdf_on_sphere(double pdf_on_square, double sin_theta) {
    constexpr double kPi = std::numbers::pi;
    return sin_theta > 0.0 ? pdf_on_square / (2.0 * kPi * kPi * sin_theta) : 0.0;
}

}  // namespace dewbow
