// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ways by which light of one order comes to a scattering angle.

#include "dewbow/rainbow/ray_pair.h"

namespace dewbow {

/// D = 2π turns + side θ.
struct Passage {
    int turns = 0, side = 1;
    double deviation = 0.0;  ///< D in radians
};

/// Calls `visit` for every passage with D from `darkest` to that of the central ray; θ in radians.
template <class Visit>
void for_each_passage(const BowGeometry& bow, double darkest, double theta, const Visit& visit) {
    constexpr double kPi = 3.14159265358979323846;
    for (int turns = 0; (2 * turns - 1) * kPi <= bow.most; ++turns)
        for (int side : {-1, 1}) {
            const double D = 2.0 * kPi * turns + side * theta;
            // On the axis both sides are one.
            const bool is_twin = side < 0 && (theta == 0.0 || theta == kPi);
            if (D >= darkest && D <= bow.most && !is_twin) visit(Passage{turns, side, D});
        }
}

/// What stands for 1 / sin θ in |S|² of ray_pair() and lone_pair(): that for light of two rays, and
/// beyond the grazing ray (most - D) / sin θ, which is 1 on the axis that the light comes along.
double focus(const BowGeometry& bow, double deviation, double theta);

/// Whether light of this deviation came along the axis that is the nearer one to it.
bool is_central(const BowGeometry& bow, double deviation);

}  // namespace dewbow
