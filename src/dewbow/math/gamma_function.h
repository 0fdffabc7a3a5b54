// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shares of the gamma function: what part of its integral lies below a point.

namespace dewbow {

/// P(a, x) = ∫₀ˣ t^{a−1} e^{−t} dt / Γ(a), the share of the integral below x.
///
/// A power series for x < a + 1, else Lentz's continued fraction for the rest.
///                                            [Abramowitz & Stegun 1964, 6.5.29, 6.5.31]
/// @param a  above 0, up to 1000.   @param x  0 and more; infinity gives 1.
/// Error: 1e-13, measured against closed forms up to a = 60.
double lower_gamma_share(double a, double x);
/// Q(a, x) = 1 − P(a, x), to full relative accuracy where it is small.
double upper_gamma_share(double a, double x);

}  // namespace dewbow
