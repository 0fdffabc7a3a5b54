// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras. The film's aspect ratio wins over theirs.

#include "dewbow/import/gltf/nodes.h"
#include "dewbow/scene/camera.h"

namespace dewbow::gltf {

/// The camera of `node`, or nothing if it has none that can be used, which is noted. Throws
/// InputError.
std::optional<CameraView> read_camera(Document& document, const PlacedNode& node);

}  // namespace dewbow::gltf
