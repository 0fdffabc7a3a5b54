// SPDX-License-Identifier: Apache-2.0
#pragma once

// Few radii that stand for a distribution of drops, chosen so that the bows' fringes come out
// right.
//
// Between a bow and its supernumeraries the intensity goes like r^k cos(2π f r + φ): the number of
// fringes between the bow and an angle grows in proportion to the radius, with the rate f. A sum
// over radii in steps Δr sees the fringes of rate f and those of 1/Δr − f alike; it is right where
// the spread of sizes has washed the latter out.

#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/drop_sizes.h"

namespace dewbow {

/// Fringes of Airy's bow between the Descartes angle and an angle that lies `from_bow` on its
/// bright side, over the drop's radius: m / r = 4/3 from_bow^{3/2} / (λ √h), from m = (2/3π)
/// z^{3/2} and z = from_bow (x²/h)^{1/3}.
/// @param airy_constant  h of DescartesRay.   @param wavelength  in the medium around.
InverseLength fringe_rate(Angle from_bow, double airy_constant, Length wavelength);

struct SizeSampling {
    /// The fastest fringes that are asked for. 0: functions that are smooth in the radius.
    InverseLength fastest{};
    /// Of ∫ n r² cos(2πfr + φ) dr over ∫ n r² dr, for all rates f up to `fastest`; 1e-6 to 0.1.
    double error = 1e-3;
    /// For models that know no small drops: those below this radius count as of it, if together
    /// they have less than a thousandth of the cross section then.
    Length least{};
};

/// Radii in ascending order, whose shares sum to 1 and whose ⟨r²⟩, ⟨r³⟩ are those of the
/// distribution to 1e-6.
///
/// The trapezoidal rule in t with r = s ln(1 + e^t), s a third of the effective radius: steps are
/// even in r where most of the cross section is, and even in ln r towards 0, where n may start like
/// a power, and towards an abrupt end. What lies below the first radius counts as of that radius.
/// As many radii as (largest − smallest) · (fastest + washed_out_rate(error)), or a dozen or two
/// where that is less. Throws InputError for more than 100,000.
std::vector<WeightedRadius> sample_sizes(const DropSizes& sizes, const SizeSampling& sampling);

/// Fringes above this rate have less than `contrast` left after averaging over the sizes, weighted
/// by cross section: beyond, a model may give the mean over fringes. Infinite for a single size;
/// at most 200 fringes over the range of radii, which an abrupt end exceeds at contrasts below
/// 1e-4.
InverseLength washed_out_rate(const DropSizes& sizes, double contrast);

}  // namespace dewbow
