// SPDX-License-Identifier: Apache-2.0
#pragma once

// How light paths and camera paths share haze. With V a point of it (letters as in weights.h):
//
//     shape                   who finds it
//     L V E                   light paths, where the lamp's ray beyond V meets a caster first;
//                             else camera paths, by next event
//     L (S|R)⁺ V E            light paths
//     L V (S|D|R)⁺ E          camera paths, by next event
//
// So weights are 0 or 1. A beam in front of a prism is a light path's, since those are aimed: next
// event would find its narrow light by chance. Where a render has no light paths, L V E is the
// camera's. V scatters once: light that comes to it from another V or from a D is not looked for.

#include "dewbow/render/prepared_scene.h"

namespace dewbow::caustics {

/// Whether light paths go on from there, where a lamp's ray meets it first.
bool goes_on(const PreparedScene& prepared, const Hit& hit);

/// Of L V E: whether light paths find it.
/// @param from_afar  whether the lamp is infinitely far: its rays begin where the scene does.
/// @param next  what the lamp's ray meets first beyond `point`.
bool light_paths_find(const PreparedScene& prepared, Vec3 point, bool from_afar, const Hit& next);

}  // namespace dewbow::caustics
