// SPDX-License-Identifier: Apache-2.0
#pragma once

// KHR_lights_punctual.

#include "dewbow/import/gltf/nodes.h"
#include "dewbow/scene/light.h"

namespace dewbow::gltf {

/// The light of `node`, or nothing if it has none that shines: a light of intensity 0, or one whose
/// node is scaled to nothing, which is noted. Throws InputError.
std::optional<Light> read_light(Document& document, const PlacedNode& node);

}  // namespace dewbow::gltf
