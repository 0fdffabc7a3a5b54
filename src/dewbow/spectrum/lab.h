// SPDX-License-Identifier: Apache-2.0
#pragma once

// CIE 1976 L*a*b*.

#include <cmath>

#include "dewbow/spectrum/colour.h"

namespace dewbow {

struct CieLab {};  ///< L*, a*, b*

// The cube root gives way to its tangent below (6/29)³.  [CIE 15:2004, §8.2.1; ISO 11664-4]
inline constexpr double kLabBreak = (6.0 / 29.0) * (6.0 / 29.0) * (6.0 / 29.0);
inline constexpr double kLabSlope = 841.0 / 108.0;

/// f(t) of L*a*b*, `t` = X/X_n, Y/Y_n or Z/Z_n.
inline double lab_curve(double t) {
    return t > kLabBreak ? std::cbrt(t) : kLabSlope * t + 4.0 / 29.0;
}
/// f′(t)
inline double lab_curve_slope(double t) {
    if (t <= kLabBreak) return kLabSlope;
    const double root = std::cbrt(t);
    return 1.0 / (3.0 * root * root);
}

/// `relative` = (X/X_n, Y/Y_n, Z/Z_n).
inline Colour<CieLab> lab_from_relative(const std::array<double, 3>& relative) {
    const double fx = lab_curve(relative[0]);
    const double fy = lab_curve(relative[1]);
    const double fz = lab_curve(relative[2]);
    return {{116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)}};
}

inline Colour<CieLab> lab_from_xyz(Colour<Xyz> xyz, Colour<Xyz> white) {
    return lab_from_relative({xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]});
}

}  // namespace dewbow
