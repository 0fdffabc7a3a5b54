// SPDX-License-Identifier: Apache-2.0
#pragma once

// EXT_mesh_gpu_instancing: one mesh in many places.

#include "dewbow/import/gltf/nodes.h"

namespace dewbow::gltf {

/// Where the node's mesh stands in the node's frame: once, or as often as the extension says.
/// Throws InputError.
std::vector<Affine> read_instances(Document& document, const Json& node);

}  // namespace dewbow::gltf
