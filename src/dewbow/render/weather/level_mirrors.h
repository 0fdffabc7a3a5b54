// SPDX-License-Identifier: Apache-2.0
#pragma once

// Level surfaces that show the sun as it is: still water, a mirror on the ground.

#include <vector>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/lanes.h"
#include "dewbow/render/media.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// Most heights that are looked at: those of the largest surfaces.
inline constexpr std::size_t kMostLevelMirrors = 4;

/// Whether a level surface of this material mirrors: smooth glass or water, a mirror, a smooth
/// metal; the same everywhere, and without a normal map. A pane and glossy paint, which do so in
/// part, are left out.
bool mirrors(const Material& material);

/// The heights (y, in m) at which the scene has such surfaces, the largest first: infinite planes,
/// rectangles, discs, sides of boxes, facets of meshes that look up or down.
std::vector<double> level_mirrors(const Scene& scene);

using ReflectanceLanes = std::array<Reflectance<double>, kMaxLanes>;

/// What such a surface, seen from the surroundings, leaves of light at each lane.
/// @param interior  the medium that its body holds, if it is one.
/// @param cosine    of the angle of incidence, 0 to 1.
void eval_mirror(const Material& material, int interior, double cosine, const LaneSet& lanes,
                 PacketMedia& media, ReflectanceLanes& out);

}  // namespace dewbow
