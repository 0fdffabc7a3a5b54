// SPDX-License-Identifier: Apache-2.0
#pragma once

// By how much falling drops of a cloud turn their bows.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/drop_shape.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/rainbow/size_sampling.h"

namespace dewbow {

/// Drops flattened as they fall, seen from one place.
struct FallingShape {
    ShapeSpread spread;
    BowPlace place;
};

/// Drops of one radius and shape. Shifts go straight from the least index to the greatest.
struct ShapedDrops {
    std::size_t radius = 0;  ///< its number in the cloud
    double share = 1.0;      ///< of the drops of that radius
    BowShifts at_least{}, at_greatest{};

    /// @param t  0 at the least index, 1 at the greatest.
    Angle shift(int p, double t) const {
        const auto k = std::size_t(p);
        return at_least[k] + t * (at_greatest[k] - at_least[k]);
    }
};

/// All radii in turn, each in the shapes that it comes in; spheres if `falling` is nothing.
/// Throws InputError as raindrop_shapes.
std::vector<ShapedDrops> shape_drops(std::span<const WeightedRadius> radii,
                                     const std::optional<FallingShape>& falling,
                                     RelativeIndex least, RelativeIndex greatest);

}  // namespace dewbow
