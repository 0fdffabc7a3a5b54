// SPDX-License-Identifier: Apache-2.0
#pragma once

// Aerial perspective: what the clear air between two points takes from light, and what it adds.

#include <memory>
#include <span>

#include "dewbow/math/vector.h"

namespace dewbow {

/// Air in daylight. Immutable; safe from several threads.
class Aerial {
public:
    virtual ~Aerial() = default;

    /// The flight of `distance_m` from a point `height_m` above sea level (y of the world; below 0
    /// as at 0) along `direction` (unit; +y is up, the ground curves away as the Earth does). By
    /// vacuum wavelength: `transmittance` is multiplied by the share of radiance that gets through,
    /// `airlight` is written: W m⁻² sr⁻¹ nm⁻¹ that sunlight and skylight scattered on the way add.
    /// Nothing between shadows the air. A distance of infinity is the way out of the atmosphere.
    virtual void eval_lanes(double height_m, Dir<World> direction, double distance_m,
                            std::span<const double> lambda_nm, std::span<double> transmittance,
                            std::span<double> airlight) const = 0;
};
using AerialPtr = std::shared_ptr<const Aerial>;

}  // namespace dewbow
