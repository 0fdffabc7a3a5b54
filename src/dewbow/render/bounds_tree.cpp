// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/bounds_tree.h"

#include <algorithm>

namespace dewbow {

namespace {

/// The node of order[first, end) and all below. Returns its index.
std::uint32_t build(BoundsTree& tree, std::span<const Bounds> boxes, std::uint32_t first,
                    std::uint32_t end, std::uint32_t most_in_leaf) {
    const auto node = std::uint32_t(tree.nodes.size());
    tree.nodes.push_back({{}, first, end - first, 0});
    Bounds bounds, centres;
    for (std::uint32_t i = first; i < end; ++i) {
        const Bounds& box = boxes[tree.order[i]];
        bounds.add(box.low);
        bounds.add(box.high);
        centres.add(box.centre());
    }
    tree.nodes[node].bounds = bounds;
    if (end - first <= most_in_leaf) return node;
    const Vec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (end - first) / 2;
    const auto order = tree.order.begin();
    std::nth_element(order + first, order + middle, order + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return boxes[a].centre()[axis] < boxes[b].centre()[axis];
                     });
    build(tree, boxes, first, middle, most_in_leaf);
    const std::uint32_t right = build(tree, boxes, middle, end, most_in_leaf);
    tree.nodes[node].right = right;
    return node;
}

}  // namespace

BoundsTree::BoundsTree(std::span<const Bounds> boxes, std::vector<std::uint32_t> members,
                       std::uint32_t most_in_leaf)
    : order(std::move(members)) {
    if (!order.empty()) build(*this, boxes, 0, std::uint32_t(order.size()), most_in_leaf);
}

}  // namespace dewbow
