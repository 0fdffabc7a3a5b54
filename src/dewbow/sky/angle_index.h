// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which two of many uneven angles stand around a given one, found at once.

#include <cstdint>
#include <span>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Scattering angles from 0° to 180°, and the cell between two of them that an angle falls into.
class AngleIndex {
public:
    /// @param angles  ascending, from 0° to 180°, at least two.
    explicit AngleIndex(std::span<const Angle> angles);

    std::size_t cells() const { return radians_.size() - 1; }
    /// Of angle number `i`.
    double radians(std::size_t i) const { return radians_[i]; }
    double cosine(std::size_t i) const { return cosines_[i]; }

    struct Place {
        std::size_t cell;  ///< between the angles of this number and the next
        double share;      ///< of the way from the one to the other, linear in the angle
    };
    /// @param cosine  of the scattering angle; beyond ±1 it counts as ±1.
    Place find(double cosine) const;

private:
    std::vector<double> radians_, cosines_;
    std::vector<std::uint32_t> first_cell_;  ///< by even bins of the angle
};

}  // namespace dewbow
