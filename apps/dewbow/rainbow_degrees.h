// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// In degrees without what the way through radians adds: 137.5 and not 137.49999999999997.
inline double degrees_of(Angle angle) {
    constexpr double kFinest = 1e12;
    return std::round(angle.to(unit::deg) * kFinest) / kFinest;
}

}  // namespace dewbow
