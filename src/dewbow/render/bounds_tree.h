// SPDX-License-Identifier: Apache-2.0
#pragma once

// Boxes in a binary tree, cut at the median along the axis in which their centres lie widest.

#include <cstdint>
#include <span>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow {

struct BoundsTree {
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0, count = 0;  ///< of order, in leaves
        std::uint32_t right = 0;             ///< the left child is the next node; 0 in leaves
    };

    BoundsTree() = default;
    /// @param members  which of the boxes there are; none of them empty.
    BoundsTree(std::span<const Bounds> boxes, std::vector<std::uint32_t> members,
               std::uint32_t most_in_leaf);

    std::vector<std::uint32_t> order;  ///< the members, leaf by leaf
    std::vector<Node> nodes;           ///< the root first; none without members
};

}  // namespace dewbow
