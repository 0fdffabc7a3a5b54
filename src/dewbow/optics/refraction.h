// SPDX-License-Identifier: Apache-2.0
#pragma once

// Snell and Fresnel at one plane interface. Templates over float and double.

#include <complex>
#include <optional>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Index of refraction against vacuum.
struct AbsoluteIndex {
    double value = 1.0;
};
/// Index of what is behind an interface against what is before it, n_t / n_i: what Snell's law
/// wants.
struct RelativeIndex {
    double value = 1.0;
    constexpr RelativeIndex inverse() const { return {1.0 / value}; }
};
constexpr RelativeIndex operator/(AbsoluteIndex transmitted, AbsoluteIndex incident) {
    return {transmitted.value / incident.value};
}

/// Angle of refraction, or nothing beyond the critical angle. [Snell; Musgrave 1989, eq. 1]
std::optional<Angle> refraction_angle(Angle incidence, RelativeIndex n);
/// Angle beyond which an interface into a rarer medium reflects all, or nothing if n >= 1.
std::optional<Angle> critical_angle(RelativeIndex n);
/// Angle at which parallel polarised light is not reflected: atan n.
Angle brewster_angle(RelativeIndex n);
/// Deviation of a ray through a prism of apex angle `apex` at minimum: 2 asin(n sin(A/2)) − A.
/// Nothing if n sin(A/2) > 1.
std::optional<Angle> minimum_deviation(Angle apex, RelativeIndex n);

/// Reflectances of the two polarisations.
template <class T>
struct Reflectance {
    T parallel, perpendicular;
    constexpr T unpolarised() const { return T(0.5) * (parallel + perpendicular); }
};

/// cos²θ_t = 1 − sin²θ_i / n², negative beyond the critical angle: written so that it does not
/// cancel near grazing incidence or near total reflection.
template <class T>
T cos2_transmitted(T cos_i, T n);

/// Fresnel reflectances at a dielectric; cos_i in [0, 1], n = n_t / n_i > 0. 1 beyond the critical
/// angle. Error: see refraction_test.cpp. [Born & Wolf §1.5.2]
template <class T>
Reflectance<T> fresnel_dielectric(T cos_i, T n);

/// Fresnel reflectances at a metal: n + ik relative to the medium of incidence, k >= 0.
template <class T>
Reflectance<T> fresnel_conductor(T cos_i, std::complex<T> n);

}  // namespace dewbow
