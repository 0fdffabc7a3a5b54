// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which convex bodies have nothing else inside them: a ray within such a body meets its own surface
// next, and need not ask the tree of all shapes.

#include <vector>

#include "dewbow/render/convex_solid.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// One a shape.  @param solids  one a shape: the convex solid of a mesh, or nullptr.
std::vector<bool> find_undisturbed(const Scene& scene,
                                   const std::vector<const ConvexSolid*>& solids);

}  // namespace dewbow
