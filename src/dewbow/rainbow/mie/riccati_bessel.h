// SPDX-License-Identifier: Apache-2.0
#pragma once

// Riccati–Bessel functions, of which waves in and around a sphere are made:
// ψ_n(z) = z j_n(z), χ_n(z) = −z y_n(z), ξ_n = ψ_n − iχ_n = z h_n^{(1)}(z), which runs outwards.
//                                                              [Bohren & Huffman 1983, §4.3, §4.4]

#include <complex>
#include <vector>

namespace dewbow {

/// Partial waves that a sphere of size parameter x > 0 needs: x + 6 x^{1/3} + 8.
///
/// Beyond n = x + t x^{1/3} they fall like exp(−(2t)^{3/2} · 2/3). Wiscombe's t = 4.05 leaves 3e-9
/// (x = 100) to 9e-8 (x = 5000) in the amplitudes; t = 6 leaves 1e-12 for less than 1 % more work.
///                                                              [Wiscombe 1980, Appl. Opt. 19,
///                                                              1505]
int term_count(double x);

/// ψ_n(x) and χ_n(x), n = 0..N.
struct RiccatiBessel {
    std::vector<double> psi, chi;
};
/// χ by upward recurrence, ψ_n = 1 / (χ_{n+1} − χ_n ψ_{n+1}/ψ_n) from the Wronskian and downward
/// ratios: each in the direction in which errors do not grow. Error: about 1e-16 √n of the
/// oscillation's amplitude for n < x, relative beyond. χ overflows for N far beyond term_count(x).
RiccatiBessel riccati_bessel(double x, int N);

/// ψ_n(z) / ψ_{n−1}(z), n = 1..N, at [n] ([0] is 0), for real or complex z ≠ 0, by the downward
/// recurrence ψ_{n−1} = (2n+1)/z ψ_n − ψ_{n+1} from where the start no longer matters. Near 0 they
/// are z / (2n+1), and differences of them keep what those of derivatives lose.
template <class T>
std::vector<T> psi_ratios(T z, int N);

/// D_n(z) = ψ_n'(z) / ψ_n(z), n = 0..N.                          [Bohren & Huffman 1983, eq. 4.89]
template <class T>
std::vector<T> logarithmic_derivatives(T z, int N);

/// ξ_n'(x) / ξ_n(x), n = 0..N, of outgoing waves; those of incoming ones, ψ_n + iχ_n, are the
/// conjugates. The imaginary part, 1 / |ξ_n|² by the Wronskian, keeps its relative accuracy where
/// it is tiny (n > x).
std::vector<std::complex<double>> outgoing_derivatives(double x, const RiccatiBessel& waves);

}  // namespace dewbow
