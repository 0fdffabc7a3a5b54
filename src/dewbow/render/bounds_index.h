// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which of many boxes overlap one: a binary tree, so that all pairs of a million shapes need not be
// looked at.

#include <functional>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow {

class BoundsIndex {
public:
    /// Empty boxes overlap nothing.
    explicit BoundsIndex(std::vector<Bounds> boxes);

    /// Whether `is_it(i)` holds for any box i that overlaps `box`, if only on its faces. Asks about
    /// no other, and no more once one was found.
    bool any(const Bounds& box, const std::function<bool(std::size_t)>& is_it) const;

    const Bounds& operator[](std::size_t i) const { return boxes_[i]; }

private:
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0, count = 0;  ///< of order_, in leaves
        std::uint32_t right = 0;             ///< the left child is the next node; 0 in leaves
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t end);

    std::vector<Bounds> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace dewbow
