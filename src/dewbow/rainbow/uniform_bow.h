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

/// In the region of two rays, with A = ζ x^{2/3},
///
///     S_j = -x^{3/2} √(2π / sin θ) e^{iψ} [P x^{-1/3} Ai(-A) + i Q x^{-2/3} Ai'(-A)],
///
/// where P is P_j + (i/x) (P_next and what Legendre's functions add), and Q likewise; beyond its
/// end S_j = -x ε_j √(b / (sin θ |dD/db|)) e^{iψ}, of the ray that is left. Light of orders above 3
/// comes to some angles more than once. The terms in 1/x are no use where x cos³i of the grazing
/// ray is small, and fade out there.
class UniformBow final : public BowPattern {
public:
    /// Throws InputError as RayPairSeries. Cost: 1 µs; the first of an order 4 ms.
    UniformBow(RelativeIndex n, int p) : pairs_(n, p) {}

    const RayPairSeries& pairs() const { return pairs_; }

    /// In Bohren and Huffman's convention. NaN where light that does not run along the axis meets
    /// on it (x b sin θ < 3), unless it has faded.
    /// Cost: 1 µs a passage, and 0.2 µs for each drop of the same shift.
    void add_amplitudes(std::span<const Drop> drops, Angle theta,
                        std::span<Amplitudes> sums) const override;

    /// Adds Σ_k weights[k] |S_j|²(drops[k], θ) to out[angle]. Light that comes to an angle more
    /// than once is added without phases, and squares of the terms in 1/x are left out. Finite
    /// everywhere: on the axis sin θ stays at the 2/(πxb) that Legendre's functions reach there.
    /// Drops that are no spheres: by angle_without_shift. Cost: 5 ns a drop and angle, and 1 µs an
    /// angle, for each new shift again.
    void add_intensities(std::span<const Drop> drops, std::span<const double> weights,
                         std::span<const Angle> theta, std::span<Intensities> out) const;

private:
    RayPairSeries pairs_;
};

}  // namespace dewbow
