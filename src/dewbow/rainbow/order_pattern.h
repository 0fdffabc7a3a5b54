// SPDX-License-Identifier: Apache-2.0
#pragma once

// The light of one order p >= 2 around its bow and away from it, for drops of every size at once.
//
// Near the bow two rays meet, joined by Airy functions as ray_pair.h says:
//
//     |S_j|² = π x² [P_j² x^{1/3} Ai²(−z x^{2/3}) + Q_j² x^{−1/3} Ai'²(−z x^{2/3})].
//
// Beyond the angle at which the second ray grazes the drop there is one ray, whose intensity is the
// same expression for large z and P_j = A z^{1/4}, Q_j = A z^{−1/4}: without a seam, for what the
// grazing ray adds to A falls like the power 3/2 of the distance from there. The light may pass 0°
// and 180° on its way. Phases of different passages are not summed.

#include <cstdint>
#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/fringe_average.h"
#include "dewbow/rainbow/ray_pair.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// The light of one order at certain angles, for drops of every size.
class BowLight {
public:
    /// Adds Σ share |S_j|² over drops to `out` [angle].   Cost: 10 ns for each angle with two rays.
    void add(const FringeAverage& drops, std::span<Intensities> out) const;
    /// Moves what is the same for all sizes, over Σ share x², to `per_square` [angle].
    void move_singles(std::span<Intensities> per_square);

private:
    friend class OrderPattern;
    /// Light that comes to an angle: of_G G(z) + of_H H(z) over `sine`.
    struct Passage {
        std::uint32_t angle;
        double z;
        Intensities of_G, of_H;
        double sine;
    };
    /// The same where there is one ray: times Σ share x².
    struct Single {
        std::uint32_t angle;
        Intensities per_square;
    };
    std::vector<Passage> pairs_;        ///< of rays; sine is in of_G and of_H
    std::vector<Passage> beside_axis_;  ///< where light meets that does not run along the axis
    std::vector<Single> singles_;
};

class OrderPattern {
public:
    /// Throws InputError as descartes_ray.   Cost: 0.1 ms (p = 2) to 1 ms (p = 7), twenty times
    /// that for indices outside those of RayPairSeries.
    OrderPattern(RelativeIndex n, int p);
    /// For an index between those of `patterns`, all of one order: their mean with `weights`, which
    /// are Lagrange's.
    OrderPattern(RelativeIndex n, std::span<const OrderPattern> patterns,
                 std::span<const double> weights);

    int order() const { return bow_.p; }

    /// At scattering angles `theta` of drops that turn the bow by `shift` (angle_without_shift).
    BowLight at(std::span<const Angle> theta, Angle shift) const;

private:
    struct Node {
        double z;
        /// P and Q of both polarisations times √(sin θ / reach), where `reach` is 1 but vanishes
        /// with the distance from the axial ray: smooth where sin θ vanishes.
        double P_perpendicular, Q_perpendicular, P_parallel, Q_parallel;
    };
    Node of_pair(double offset, const RayPair<double>& pair) const;
    /// Beyond the grazing ray; signs as those of a node before it.
    Node of_ray(double offset, const Node& before) const;
    Node interpolated(double position) const;
    /// @param brightness  what its light counts for.
    void add_passage(double turn, double sine, double brightness, std::uint32_t angle,
                     BowLight& light) const;

    BowGeometry bow_;
    double first_ = 0.0, step_ = 0.0;  ///< of the nodes, in deflection from the bow's, radians
    std::vector<Node> nodes_;
};

}  // namespace dewbow
