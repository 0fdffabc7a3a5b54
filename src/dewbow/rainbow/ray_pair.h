// SPDX-License-Identifier: Apache-2.0
#pragma once

// The two rays that leave a drop in one direction beside its bow, as the uniform approximation
// needs them: joined so that nothing is singular where they meet. And the one that is left.
//
// Light of order p, with impact parameter b for the partial wave n = xb - 1/2, adds up to
//
//     S_j(θ) = -½ x^{3/2} √(2/(π sin θ)) e^{iψ} ∫ g_j(b) (1 + i c_j(b)/x + …) e^{ixΦ(b)} db,
//     Φ(b) = 2 (p n cos r - cos i) - b (D(b) - D),   g_j = √b (1 - r_j²) (-r_j)^{p-1},
//
// whose points of stationary phase are the rays with the deviation D. A change of variable to
// Φ = η - (t³/3 - ζt) turns it into Airy functions of -ζ x^{2/3}, and g_j db/dt into P + Q t + …
// with P and Q smooth in D.  [Chester, Friedman & Ursell 1957; Bleistein 1966; Debye's expansions
// of the Hankel functions and of r_j, DLMF 10.19.6; of Legendre's functions, Szegő 1939, 8.21]

#include <array>
#include <complex>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

/// Orders that the approximation covers: p chords inside the drop.
inline constexpr int kLowestBow = 2, kHighestBow = 7;

/// A bow as seen along the deviation D, in radians.
struct BowGeometry {
    double n = 0.0;
    int p = 2;
    double least = 0.0;      ///< D of the Descartes ray, where the two meet
    double span = 0.0;       ///< from there to D of the grazing ray b = 1, where one ends
    double incidence = 0.0;  ///< of the Descartes ray
    double curvature = 0.0;  ///< h = ½ d²D/db² there
    double most = 0.0;       ///< D of the central ray b = 0, (p - 1)π
    double grazing() const { return least + span; }
};
/// Throws InputError unless p >= 2 and 1 < n < p.
BowGeometry bow_geometry(RelativeIndex n, int p);

/// For one polarisation: P and Q of g, of g / b, and of the first correction in 1/x.
template <class Number>
struct PairAmplitude {
    Number P, Q, P_over_b, Q_over_b, P_next, Q_next;
};

/// Functions of D - least, for all sizes.
template <class Number>
struct RayPair {
    Number zeta;  ///< ζ: positive where there are two rays
    Number path;  ///< η, in radii
    PairAmplitude<Number> perpendicular, parallel;

    static constexpr int kCount = 14;
    /// All of them.
    std::array<Number*, kCount> list() { return list_of<Number>(*this); }
    std::array<const Number*, kCount> list() const { return list_of<const Number>(*this); }
    /// Those that grow without limit towards the grazing end, as (span - offset)^{-3/2}.
    std::array<Number*, 4> singular() {
        return {&perpendicular.P_next, &perpendicular.Q_next, &parallel.P_next, &parallel.Q_next};
    }

private:
    template <class Item, class Self>
    static std::array<Item*, kCount> list_of(Self& self) {
        auto &s = self.perpendicular, &p = self.parallel;
        return {&self.zeta, &self.path, &s.P, &s.Q,        &s.P_over_b, &s.Q_over_b, &s.P_next,
                &s.Q_next,  &p.P,       &p.Q, &p.P_over_b, &p.Q_over_b, &p.P_next,   &p.Q_next};
    }
};

/// At D = least + `offset`, which is not zero, and may be complex.
RayPair<std::complex<double>> separate_rays(const BowGeometry& bow, std::complex<double> offset);

/// At a real offset below span, at the bow itself as well: there as the mean over a circle around
/// it in the complex plane, on which the rays are apart. [Cauchy]
/// Error: 1e-11 of each function's largest, 1e-8 for P_next and Q_next.
RayPair<double> ray_pair(const BowGeometry& bow, double offset);

/// The ray that is left between the grazing one and the central one.
struct LoneRay {
    double path;                     ///< 2 (p n cos r - cos i), in radii
    double perpendicular, parallel;  ///< ε √(b / (|dD/db| (most - D))): finite on the axis
};
/// At D = least + `offset`, between grazing() and `most`.   Error: rounding.
LoneRay lone_ray(const BowGeometry& bow, double offset);

/// The same form for it: P = ∓√ζ Q leaves nothing of the other ray, which is thought to run on
/// along the surface, so that ζ and η have no seam. P and Q lack a factor √(most - D); what belongs
/// to 1/x is zero.
RayPair<double> lone_pair(const BowGeometry& bow, double offset, const LoneRay& ray);

}  // namespace dewbow
