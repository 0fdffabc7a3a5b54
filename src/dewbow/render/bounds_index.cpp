// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/bounds_index.h"

#include <algorithm>

namespace dewbow {

namespace {
constexpr std::uint32_t kMostInLeaf = 4;
}

BoundsIndex::BoundsIndex(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (!boxes_[i].empty()) order_.push_back(std::uint32_t(i));
    if (!order_.empty()) build(0, std::uint32_t(order_.size()));
}

/// The node of order_[first, end), cut at the median along the axis in which its centres lie
/// widest. Returns its index.
std::uint32_t BoundsIndex::build(std::uint32_t first, std::uint32_t end) {
    const auto node = std::uint32_t(nodes_.size());
    nodes_.push_back({{}, first, end - first, 0});
    Bounds bounds, centres;
    for (std::uint32_t i = first; i < end; ++i) {
        const Bounds& box = boxes_[order_[i]];
        bounds.add(box.low);
        bounds.add(box.high);
        centres.add(box.centre());
    }
    nodes_[node].bounds = bounds;
    if (end - first <= kMostInLeaf) return node;
    const Vec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return boxes_[a].centre()[axis] < boxes_[b].centre()[axis];
                     });
    build(first, middle);
    nodes_[node].right = build(middle, end);
    return node;
}

bool BoundsIndex::any(const Bounds& box, const std::function<bool(std::size_t)>& is_it) const {
    std::vector<std::uint32_t> pending;
    if (!nodes_.empty()) pending.push_back(0);
    while (!pending.empty()) {
        const std::uint32_t at = pending.back();
        pending.pop_back();
        const Node& node = nodes_[at];
        if (!node.bounds.overlaps(box)) continue;
        if (node.right) {
            pending.push_back(node.right);
            pending.push_back(at + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (boxes_[order_[i]].overlaps(box) && is_it(order_[i])) return true;
    }
    return false;
}

}  // namespace dewbow
