// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tree of nodes: where things stand.

#include <functional>

#include "dewbow/import/gltf/animation.h"
#include "dewbow/math/transform.h"

namespace dewbow::gltf {

/// Deepest chain of nodes that is taken.
inline constexpr int kMaxNodeDepth = 64;

struct PlacedNode {
    Json json;
    Affine world_from_node;  ///< finite, possibly singular
    std::string name;        ///< empty if it has none
    std::size_t index = 0;   ///< among the file's nodes
    bool visible = true;     ///< neither it nor one above it is hidden [KHR_node_visibility]
};

/// Calls `visit` for every node of the scene that the file shows, as `pose` places them, parents
/// before children. A node with two parents, which a cycle has too, is an InputError.
void for_each_node(Document& document, const Pose& pose,
                   const std::function<void(const PlacedNode&)>& visit);

/// The rotation of a quaternion x, y, z, w of any length; nothing if it is zero.
std::optional<Affine> rotation_of(const std::vector<double>& quaternion);

}  // namespace dewbow::gltf
