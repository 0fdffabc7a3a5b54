// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/lanes.h"
#include "dewbow/render/surface_inputs.h"

namespace dewbow {

/// One place of a surface as a path meets it. Directions at surfaces are local and point away from
/// them; z > 0 is the side that is looked at.
struct SurfaceView {
    const SurfaceInputs& inputs;
    const LaneSet& lanes;
    const LaneValues& outside;  ///< index of the medium in front, against vacuum, at each lane
    Vec3 wo;                    ///< to where the path came from, unit, wo.z > 0
};

}  // namespace dewbow
