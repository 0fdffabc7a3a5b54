// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a sphere makes of a plane wave, by partial waves (Lorenz–Mie).

#include <complex>
#include <vector>

#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Amplitudes of the partial waves that a sphere scatters, a_n (electric) and b_n (magnetic), of
/// order n = 1..N at [n − 1].                                        [Bohren & Huffman 1983,
/// eq. 4.53]
struct PartialWaves {
    std::vector<std::complex<double>> a, b;
};

/// Sizes that Mie theory is tested for, and the largest |m| x (the cost grows with it).
inline constexpr double kSmallestSize = 1e-3, kLargestSize = 50000.0, kLargestInnerSize = 1e7;

/// Of a homogeneous sphere of size parameter x, kSmallestSize to kLargestSize; N = term_count(x).
///
/// a_n = N / (N − iM), N = G ψ_n + ψ_{n+1}, M = G χ_n + χ_{n+1}, with r = ψ_{n+1}(mx) / ψ_n(mx) in
/// G = (n+1)/x · (1/m² − 1) − r/m, and for b_n in G = −m r: eq. 4.88 of Bohren & Huffman (1983),
/// freed of what cancels in small spheres. By the Wronskian Im(N M*) = Im G, so that
/// Re a_n = (|N|² − Im G) / |N − iM|² is scattering plus absorption, each with all its digits.
/// Throws InputError for sizes and indices outside.
PartialWaves mie_waves(ComplexIndex index, double x);

/// Of a perfect conductor: ψ_n' / ξ_n' and ψ_n / ξ_n, the limit m → ∞. Throws InputError as above.
///                                                                  [van de Hulst 1957, §9.22]
PartialWaves conductor_waves(double x);

/// Q_ext, Q_sca and g.                                    [Bohren & Huffman 1983, eqs. 4.61, 4.62,
/// p. 120]
Efficiencies efficiencies_of(const PartialWaves& waves, double x);

/// 4π times the differential cross section at 180°, over πa²: 4 |S(180°)|² / x².
///                                                                  [Bohren & Huffman 1983,
///                                                                  eq. 4.82]
double backscatter_efficiency(const PartialWaves& waves, double x);

}  // namespace dewbow
