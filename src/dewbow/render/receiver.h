// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/math/vector.h"

namespace dewbow {

/// A point that takes light, as far as the choice of a light cares.
struct Receiver {
    Vec3 position;
    /// Unit: only light from before it counts. Zero: light from everywhere counts.
    Vec3 normal{};

    bool one_sided() const { return dot(normal, normal) > 0.0; }
};

}  // namespace dewbow
