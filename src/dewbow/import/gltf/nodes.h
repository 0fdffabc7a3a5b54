// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tree of nodes: where things stand.

#include <functional>

#include "dewbow/import/gltf/document.h"
#include "dewbow/math/transform.h"

namespace dewbow::gltf {

/// Deepest chain of nodes that is taken.
inline constexpr int kMaxNodeDepth = 64;

struct PlacedNode {
    Json json;
    Affine world_from_node;  ///< finite, possibly singular
    std::string name;        ///< empty if it has none
};

/// Calls `visit` for every node of the scene that the file shows, parents before children. A node
/// with two parents, which a cycle has too, is an InputError.
void for_each_node(Document& document, const std::function<void(const PlacedNode&)>& visit);

}  // namespace dewbow::gltf
