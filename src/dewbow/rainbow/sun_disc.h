// SPDX-License-Identifier: Apache-2.0
#pragma once

// A source with extent: what its disc does to a bow.

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Radius of the sun as seen at its mean distance, 959.63″.     [Auwers 1891; IAU]
inline constexpr Angle kSunRadius = 0.26656 * unit::deg;

/// A round source, brighter in the middle by the linear law I(μ) = 1 − u (1 − μ).
struct SunDisc {
    Angle radius = kSunRadius;    ///< 0: a point
    double limb_darkening = 0.0;  ///< u, 0 to 1; the sun about 0.6 in the visible
};

}  // namespace dewbow
