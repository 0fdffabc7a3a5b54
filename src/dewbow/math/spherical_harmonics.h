// SPDX-License-Identifier: Apache-2.0
#pragma once

// Associated Legendre functions in the form that the addition theorem of a phase function wants.

#include <cstddef>
#include <span>

namespace dewbow {

/// How many (m, l) there are with 0 ≤ m ≤ l ≤ degree.
constexpr std::size_t harmonic_count(int degree) {
    return static_cast<std::size_t>(degree + 1) * (degree + 2) / 2;
}
/// Where (m, l) stands: m by m, and l ascending from m.
constexpr std::size_t harmonic_index(int degree, int m, int l) {
    return static_cast<std::size_t>(m) * (2 * degree + 3 - m) / 2 + (l - m);
}

/// Λ_l^m(μ) = √((l − m)! / (l + m)!) |P_l^m(μ)'s sign-free form|, that is without the phase
/// (−1)^m, for all (m, l) up to a degree, so that
/// P_l(cos θ) = Σ_m (2 − δ_m0) Λ_l^m(μ) Λ_l^m(μ') cos m(φ − φ').
/// @param mu  −1 to 1.   @param out  harmonic_count(degree) values.
/// Error: 1e-14 at degree 32.                                       [Abramowitz & Stegun 8.5.3]
void legendre_harmonics(int degree, double mu, std::span<double> out);

}  // namespace dewbow
