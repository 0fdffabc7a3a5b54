// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace dewbow {

/// (1 − cos θ)⁵.
inline double grazing(double cosine) {
    const double x = std::max(0.0, 1.0 - cosine);
    return (x * x) * (x * x) * x;
}

/// Schlick's approximation of Fresnel's reflectance, which glTF prescribes, from that at normal to
/// that at grazing incidence.                                                      [Schlick 1994]
inline double schlick(double f0, double f90, double grazing) { return f0 + (f90 - f0) * grazing; }

/// Averaged over the hemisphere, 2 ∫ F μ dμ.
constexpr double average_schlick(double f0, double f90) { return f0 + (f90 - f0) / 21.0; }

}  // namespace dewbow
