// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/bounds_index.h"

namespace dewbow {

namespace {
constexpr std::uint32_t kMostInLeaf = 4;
}

BoundsIndex::BoundsIndex(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
    std::vector<std::uint32_t> members;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (!boxes_[i].empty()) members.push_back(std::uint32_t(i));
    tree_ = BoundsTree(boxes_, std::move(members), kMostInLeaf);
}

bool BoundsIndex::any(const Bounds& box, const std::function<bool(std::size_t)>& is_it) const {
    std::vector<std::uint32_t> pending;
    if (!tree_.nodes.empty()) pending.push_back(0);
    while (!pending.empty()) {
        const std::uint32_t at = pending.back();
        pending.pop_back();
        const BoundsTree::Node& node = tree_.nodes[at];
        if (!node.bounds.overlaps(box)) continue;
        if (node.right) {
            pending.push_back(node.right);
            pending.push_back(at + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (boxes_[tree_.order[i]].overlaps(box) && is_it(tree_.order[i])) return true;
    }
    return false;
}

}  // namespace dewbow
