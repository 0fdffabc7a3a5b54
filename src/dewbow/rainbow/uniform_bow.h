// SPDX-License-Identifier: Apache-2.0
#pragma once

// The light of one bow by the uniform approximation, for drops of one index and any size.

#include <algorithm>
#include <span>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/bow_model.h"
#include "dewbow/rainbow/ray_pair_series.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// The scattering angles between which light of an order comes from two rays: real ones inside the
/// bow, complex ones on its dark side.
struct TwoRayRegion {
    Angle dark;     ///< 0° or 180°: towards it the light fades out
    Angle bow;      ///< of the Descartes ray
    Angle grazing;  ///< where one of the two grazes the drop's edge, b = 1, and ends
    bool contains(Angle theta) const {
        return theta >= std::min(dark, grazing) && theta <= std::max(dark, grazing);
    }
};
/// Throws InputError unless p >= 2 and 1 < n < p.
TwoRayRegion two_ray_region(RelativeIndex n, int p);

/// With A = ζ x^{2/3}, for each way by which light of the order comes to an angle (above p = 3
/// there can be several),
///
///     S_j = -x^{3/2} √(2π / sin θ) e^{iψ} [P x^{-1/3} Ai(-A) + i Q x^{-2/3} Ai'(-A)],
///
/// where P is P_j + (i/x) (P_next and what Legendre's functions add), and Q likewise. Beyond the
/// grazing ray that is a single ray, with lone_pair(). The terms in 1/x are no use where x cos³i of
/// the ray nearer to the edge is small, and fade out there.
class UniformBow final : public BowPattern {
public:
    /// Throws InputError as RayPairSeries. Cost: 1 µs; the first of an order 4 ms.
    UniformBow(RelativeIndex n, int p) : series_(n, p) {}

    const RayPairSeries& series() const { return series_; }

    /// In Bohren and Huffman's convention. NaN where light that does not run along the axis meets
    /// on it (x sin θ < 4), unless it has faded.
    /// Cost for each passage: 0.15 µs an angle, for each new shift again, and 50 ns a drop and
    /// angle.
    void add_amplitudes(std::span<const Drop> drops, std::span<const Angle> theta,
                        std::span<Amplitudes> sums) const override;

private:
    RayPairSeries series_;
};

}  // namespace dewbow
