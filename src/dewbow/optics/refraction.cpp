// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/refraction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewbow {
namespace {

// Everything below is written in q = n cos(theta_t), the normal component of the refracted wave
// vector in units of the incident one. With s² = sin²(theta_i) = (1 − c)(1 + c), Snell's law gives
//     q² = n² − s² = (n − 1)(n + 1) + c²,
// and because c² − q² = −(n − 1)(n + 1) no difference of nearly equal numbers is left:
//     r_perpendicular = (c − q) / (c + q) = −(n − 1)(n + 1) / (c + q)²
//     r_parallel      = r_perpendicular (c q − s²) / (c q + s²)                   [Born & Wolf
//     §1.5.2]
// Floats are evaluated in double: near total reflection the float square root alone would cost
// 1e-3.

/// Below this n², the form n² − s² of q² is the more precise one; above, (n − 1)(n + 1) + c².
/// Both are good to 2 ulp of 1 at the border, so its place does not matter.
constexpr double kSmallIndexSquared = 0.5;

double sin_squared(double cos_i) { return (1.0 - cos_i) * (1.0 + cos_i); }

/// q² = n² cos²(theta_t); negative beyond the critical angle.
double normal_component_squared(double cos_i, double n) {
    const double n2 = n * n;
    return n2 < kSmallIndexSquared ? n2 - sin_squared(cos_i)
                                   : (n - 1.0) * (n + 1.0) + cos_i * cos_i;
}

double cos2_transmitted_in_double(double cos_i, double n) {
    constexpr double kLeast = std::numeric_limits<double>::min();  // n² must not vanish
    return normal_component_squared(cos_i, n) / std::max(n * n, kLeast);
}

Reflectance<double> dielectric_in_double(double cos_i, double n) {
    if (n == 1.0) return {0.0, 0.0};  // no interface, at grazing incidence neither
    const double q2 = normal_component_squared(cos_i, n);
    if (q2 < 0.0) return {1.0, 1.0};
    const double q = std::sqrt(q2);
    const double s2 = sin_squared(cos_i);
    const double sum = cos_i + q;
    const double perpendicular = std::abs((n - 1.0) * (n + 1.0)) / (sum * sum);
    const double R_perpendicular = std::min(perpendicular * perpendicular, 1.0);
    if (s2 == 0.0) return {R_perpendicular, R_perpendicular};
    const double ratio = (cos_i * q - s2) / (cos_i * q + s2);
    return {R_perpendicular * (ratio * ratio), R_perpendicular};
}

/// The same formulas with n + ik for n: q = a + ib has q² = u + iv with u = n² − k² − s², v = 2nk.
Reflectance<double> conductor_in_double(double cos_i, double n, double k) {
    if (n == 1.0 && k == 0.0) return {0.0, 0.0};
    const double u = normal_component_squared(cos_i, n) - k * k;
    const double v = 2.0 * n * k;
    // The root with a, b >= 0 (the wave decays inwards); the larger part first, the other from v =
    // 2ab.
    const double larger = std::sqrt(0.5 * (std::hypot(u, v) + std::abs(u)));
    const double smaller = larger > 0.0 ? 0.5 * v / larger : 0.0;
    const double a = u >= 0.0 ? larger : smaller;
    const double b = u >= 0.0 ? smaller : larger;

    const double s2 = sin_squared(cos_i);
    const double sum2 = (cos_i + a) * (cos_i + a) + b * b;
    const double difference_re = (n - 1.0) * (n + 1.0) - k * k;  // of (n + ik)² − 1 = q² − c²
    const double perpendicular = std::hypot(difference_re, v) / sum2;
    const double R_perpendicular = std::min(perpendicular * perpendicular, 1.0);
    if (s2 == 0.0) return {R_perpendicular, R_perpendicular};
    const double ca = cos_i * a, cb = cos_i * b;
    const double ratio2 = ((ca - s2) * (ca - s2) + cb * cb) / ((ca + s2) * (ca + s2) + cb * cb);
    return {R_perpendicular * ratio2, R_perpendicular};
}

template <class T>
Reflectance<T> narrowed(const Reflectance<double>& r) {
    return {static_cast<T>(r.parallel), static_cast<T>(r.perpendicular)};
}

}  // namespace

// From the tangent, tan(theta_t) = s / q, because asin loses half the digits near 90°.
std::optional<Angle> refraction_angle(Angle incidence, RelativeIndex n) {
    const double q2 = normal_component_squared(cos(incidence), n.value);
    if (q2 < 0.0) return std::nullopt;
    return std::atan2(sin(incidence), std::sqrt(q2)) * unit::rad;
}

std::optional<Angle> critical_angle(RelativeIndex n) {
    if (n.value >= 1.0) return std::nullopt;
    return std::atan2(n.value, std::sqrt((1.0 - n.value) * (1.0 + n.value))) * unit::rad;
}

Angle brewster_angle(RelativeIndex n) { return std::atan(n.value) * unit::rad; }

std::optional<Angle> minimum_deviation(Angle apex, RelativeIndex n) {
    const double sin_incidence = n.value * sin(0.5 * apex);
    if (sin_incidence > 1.0) return std::nullopt;
    return 2.0 * std::asin(sin_incidence) * unit::rad - apex;
}

template <class T>
T cos2_transmitted(T cos_i, T n) {
    return static_cast<T>(cos2_transmitted_in_double(cos_i, n));
}

template <class T>
Reflectance<T> fresnel_dielectric(T cos_i, T n) {
    return narrowed<T>(dielectric_in_double(cos_i, n));
}

template <class T>
Reflectance<T> fresnel_conductor(T cos_i, std::complex<T> n) {
    return narrowed<T>(conductor_in_double(cos_i, n.real(), n.imag()));
}

template float cos2_transmitted(float, float);
template double cos2_transmitted(double, double);
template Reflectance<float> fresnel_dielectric(float, float);
template Reflectance<double> fresnel_dielectric(double, double);
template Reflectance<float> fresnel_conductor(float, std::complex<float>);
template Reflectance<double> fresnel_conductor(double, std::complex<double>);

}  // namespace dewbow
