// SPDX-License-Identifier: Apache-2.0
#pragma once

// The yardstick of mie_speed: Wiscombe's algorithm, on which his program MIEV0 rests, written down
// again from its description. For real indices, which are what is timed.
//
// W. J. Wiscombe, "Mie scattering calculations: advances in technique and fast, vector-speed
// computer codes", NCAR/TN-140+STR (1979); "Improved Mie scattering algorithms", Applied Optics 19,
// 1505 (1980).

#include <complex>
#include <span>

namespace dewbow::bench {

struct WiscombeResult {
    double extinction = 0.0, scattering = 0.0, asymmetry = 0.0;
};

/// S1 and S2 at angles of cosine `mu`. If they lie symmetrically around 90°, `symmetric` says so,
/// and only half of them are summed. Wiscombe's signs: conjugates of ours.
WiscombeResult wiscombe_mie(double x, double index, std::span<const double> mu, bool symmetric,
                            std::span<std::complex<double>> S1, std::span<std::complex<double>> S2);

}  // namespace dewbow::bench
