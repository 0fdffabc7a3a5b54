// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which of many boxes overlap one: by a tree, so that all pairs of a million shapes need not be
// looked at.

#include <functional>
#include <vector>

#include "dewbow/render/bounds_tree.h"

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
    std::vector<Bounds> boxes_;
    BoundsTree tree_;
};

}  // namespace dewbow
