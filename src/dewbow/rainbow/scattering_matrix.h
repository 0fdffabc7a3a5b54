// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a sphere does to light's Stokes vector.

#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// The four elements of a sphere's scattering matrix: it takes the Stokes vector (I, Q, U, V),
/// with Q > 0 for light polarised parallel to the scattering plane, to
/// ((S11 I + S12 Q), (S12 I + S11 Q), (S33 U + S34 V), (−S34 U + S33 V)) / k²r².
///                                                                  [Bohren & Huffman 1983,
///                                                                  eq. 4.77]
struct ScatteringMatrix {
    double S11 = 0.0, S12 = 0.0, S33 = 0.0, S34 = 0.0;
    /// −S12 / S11: of unpolarised light, positive where perpendicular light is stronger.
    constexpr double degree_of_polarisation() const { return -S12 / S11; }
};

inline ScatteringMatrix scattering_matrix(const Amplitudes& S) {
    const double perpendicular = std::norm(S.perpendicular), parallel = std::norm(S.parallel);
    const std::complex<double> mixed = S.parallel * std::conj(S.perpendicular);
    return {0.5 * (parallel + perpendicular), 0.5 * (parallel - perpendicular), mixed.real(),
            mixed.imag()};
}

}  // namespace dewbow
