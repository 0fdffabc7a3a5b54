// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scattering angles folded at 90°, where π_n and τ_n of 180° − θ are those of θ but for signs.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// An angle from the nearer end of the axis, and the places in the caller's list of the direction
/// at that angle around the forward end and around the backward end, or -1.
struct FoldedAngle {
    double from_axis = 0.0;  ///< in radians, 0 to π/2
    int forward = -1, backward = -1;

    /// 1 − cos from_axis, with all its digits.
    double off_axis() const;
};

/// First the pairs θ, 180° − θ, then what lies forward alone, then what lies backward alone. Angles
/// that differ by less than 1e-15 rad, a few roundings of one near π, count as one: at x = 50,000
/// that changes phases by 5e-11.
std::vector<FoldedAngle> fold_angles(std::span<const Angle> theta);

}  // namespace dewbow
