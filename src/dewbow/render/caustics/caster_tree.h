// SPDX-License-Identifier: Apache-2.0
#pragma once

// Boxes in groups, for aiming: few groups, whose own boxes show lamps little that is empty.

#include <cstdint>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow::caustics {

struct BoxGroup {
    Bounds bounds;
    std::vector<std::uint32_t> members;  ///< indices of the boxes
};

/// At most `most` groups. Of all cuts through a binary tree over the boxes it is about the one
/// whose groups have the least surface in all: a quarter of its surface is what a box shows on
/// average. [Surface area heuristic: MacDonald & Booth 1990; Wald 2007 for the bins]
std::vector<BoxGroup> group_boxes(const std::vector<Bounds>& boxes, std::size_t most);

/// Surface of a box, m².
double surface_of(const Bounds& box);

}  // namespace dewbow::caustics
