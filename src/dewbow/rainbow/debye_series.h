// SPDX-License-Identifier: Apache-2.0
#pragma once

// The Debye series: what a sphere does to each partial wave, order by order.
//
// A partial wave that runs inwards meets the surface as a ray does: part is reflected outside
// (R_22), part goes in (T_21), is reflected inside again and again (R_11), and part leaks out each
// time (T_12):
//
//   a_n = ½ [1 − R_22 − Σ_{p≥1} T_21 R_11^{p−1} T_12],   b_n with those of the other polarisation.
//                       [Debye 1908; Hovenac & Lock 1992, J. Opt. Soc. Am. A 9, 781, eqs. 2 to 9]
//
// The ½ is diffraction. It is counted with p = 0, whose terms then vanish for waves that pass the
// drop by; alone, its sum over n would not end.
//
// In drops much smaller than the wavelength orders mean nothing by themselves: each b_n is of order
// x, their sum x⁵, and the sum has lost as many digits.

#include <complex>
#include <vector>

#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/mie/partial_waves.h"

namespace dewbow {

/// Largest size parameter for which the series is tested; the smallest is Mie's.
inline constexpr double kLargestDebyeSize = 20000.0;

/// The series of one sphere. Terms of order p are those of rays along p chords.
class DebyeSeries {
public:
    /// Throws InputError unless the index is at least 1 (and at most kLargestInnerSize / x) and the
    /// size between kSmallestSize and kLargestDebyeSize.
    DebyeSeries(RelativeIndex index, double size_parameter);

    /// Amplitudes of light of order p >= 0.
    PartialWaves order(int p) const;
    /// Of all orders above p >= 0 together: the geometric series −½ T_21 T_12 R_11^p / (1 − R_11).
    PartialWaves beyond(int p) const;
    /// Of all orders: what Mie's series has.
    PartialWaves all() const;

private:
    using Complex = std::complex<double>;
    struct Wave {
        Complex outside;  ///< ½ (1 − R_22)
        Complex through;  ///< −½ T_21 T_12
        Complex inside;   ///< R_11
        Complex leak;     ///< 1 − R_11, also where R_11 is nearly 1
    };
    template <class Term>
    PartialWaves collect(Term term) const;

    std::vector<Wave> tm_, te_;  ///< of a_n and of b_n, at [n − 1]
};

}  // namespace dewbow
