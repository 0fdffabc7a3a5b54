// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caster_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <queue>

namespace dewbow::caustics {

namespace {

/// Leaves of the tree hold so many boxes that there are not many more of them than this: 50 MB.
constexpr std::size_t kMostLeaves = std::size_t{1} << 18;
/// Parts take the place of a whole if they have less than this share of its surface: each group
/// costs time whenever a density is asked for.
constexpr double kWorthParting = 0.9;
constexpr int kBins = 16;

void join(Bounds& a, const Bounds& b) {
    if (b.empty()) return;
    a.add(b.low);
    a.add(b.high);
}

struct Node {
    Bounds bounds;
    std::uint32_t first, end;
    int left = -1, right = -1, parent = -1;
    double least = 0.0;  ///< surface of the best cut below
    bool whole = true;   ///< whether that cut is the node itself
};

class Tree {
public:
    explicit Tree(const std::vector<Bounds>& boxes) : boxes_(boxes), order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        in_leaf_ = std::uint32_t((boxes.size() + kMostLeaves - 1) / kMostLeaves);
        if (!boxes.empty()) build(0, std::uint32_t(boxes.size()), -1);
    }

    std::vector<BoxGroup> cut(std::size_t most) {
        std::size_t count = nodes_.empty() ? 0 : count_groups(0);
        merge(count, most);
        std::vector<BoxGroup> groups;
        if (!nodes_.empty()) collect(0, groups);
        return groups;
    }

private:
    int build(std::uint32_t first, std::uint32_t end, int parent) {
        const int id = int(nodes_.size());
        nodes_.push_back({{}, first, end});
        Bounds bounds;
        for (std::uint32_t i = first; i < end; ++i) join(bounds, boxes_[order_[i]]);
        const double surface = surface_of(bounds);
        nodes_[std::size_t(id)].bounds = bounds;
        nodes_[std::size_t(id)].parent = parent;
        nodes_[std::size_t(id)].least = surface;
        if (end - first <= in_leaf_) return id;
        const std::uint32_t middle = part(first, end);
        const int left = build(first, middle, id), right = build(middle, end, id);
        Node& node = nodes_[std::size_t(id)];
        node.left = left, node.right = right;
        const double parted = nodes_[std::size_t(left)].least + nodes_[std::size_t(right)].least;
        node.whole = !(parted < kWorthParting * surface);
        if (!node.whole) node.least = parted;
        return id;
    }

    /// Puts the boxes of a node in two parts; returns where the second begins.
    std::uint32_t part(std::uint32_t first, std::uint32_t end) {
        Bounds centres;
        for (std::uint32_t i = first; i < end; ++i) centres.add(boxes_[order_[i]].centre());
        double best = std::numeric_limits<double>::infinity();
        int best_axis = 0, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto [cost, bin] = best_plane(first, end, centres, axis);
            if (cost < best) best = cost, best_axis = axis, best_bin = bin;
        }
        const auto middle =
            std::partition(order_.begin() + first, order_.begin() + end, [&](std::uint32_t box) {
                return bin_of(boxes_[box].centre(), centres, best_axis) < best_bin;
            });
        const auto at = std::uint32_t(middle - order_.begin());
        return at > first && at < end ? at : first + (end - first) / 2;
    }

    static int bin_of(Vec3 centre, const Bounds& centres, int axis) {
        const double width = centres.high[axis] - centres.low[axis];
        if (!(width > 0.0)) return 0;
        return std::min(int(kBins * ((centre[axis] - centres.low[axis]) / width)), kBins - 1);
    }

    struct Plane {
        double cost;
        int bin;  ///< the first of the second part
    };
    Plane best_plane(std::uint32_t first, std::uint32_t end, const Bounds& centres,
                     int axis) const {
        std::array<Bounds, kBins> bins;
        std::array<int, kBins> counts{};
        for (std::uint32_t i = first; i < end; ++i) {
            const Bounds& box = boxes_[order_[i]];
            const auto bin = std::size_t(bin_of(box.centre(), centres, axis));
            join(bins[bin], box);
            ++counts[bin];
        }
        std::array<double, kBins> right_cost{};
        Bounds right;
        for (int bin = kBins - 1, count = 0; bin > 0; --bin) {
            join(right, bins[std::size_t(bin)]);
            count += counts[std::size_t(bin)];
            right_cost[std::size_t(bin)] = count ? surface_of(right) * count : 0.0;
        }
        Plane best{std::numeric_limits<double>::infinity(), kBins};
        Bounds left;
        for (int bin = 1, count = 0; bin < kBins; ++bin) {
            join(left, bins[std::size_t(bin - 1)]);
            count += counts[std::size_t(bin - 1)];
            if (count == 0 || count == int(end - first)) continue;
            const double cost = surface_of(left) * count + right_cost[std::size_t(bin)];
            if (cost < best.cost) best = {cost, bin};
        }
        return best;
    }

    std::size_t count_groups(int id) const {
        const Node& node = nodes_[std::size_t(id)];
        return node.whole ? 1 : count_groups(node.left) + count_groups(node.right);
    }

    /// Of the nodes above the groups.
    template <class Visit>
    void for_each_parted(int id, const Visit& visit) const {
        const Node& node = nodes_[std::size_t(id)];
        if (node.whole) return;
        visit(id);
        for_each_parted(node.left, visit);
        for_each_parted(node.right, visit);
    }

    bool mergeable(const Node& node) const {
        return !node.whole && nodes_[std::size_t(node.left)].whole &&
               nodes_[std::size_t(node.right)].whole;
    }

    /// Puts parts together again where that adds the least surface, until there are few enough.
    void merge(std::size_t count, std::size_t most) {
        using Candidate = std::pair<double, int>;
        std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
        const auto propose = [&](int id) {
            const Node& node = nodes_[std::size_t(id)];
            if (!mergeable(node)) return;
            const double parted = surface_of(nodes_[std::size_t(node.left)].bounds) +
                                  surface_of(nodes_[std::size_t(node.right)].bounds);
            candidates.emplace(surface_of(node.bounds) - parted, id);
        };
        if (count > most) for_each_parted(0, propose);
        for (; count > most; --count) {
            Node& node = nodes_[std::size_t(candidates.top().second)];
            candidates.pop();
            node.whole = true;
            if (node.parent >= 0) propose(node.parent);
        }
    }

    void collect(int id, std::vector<BoxGroup>& groups) const {
        const Node& node = nodes_[std::size_t(id)];
        if (!node.whole) {
            collect(node.left, groups);
            collect(node.right, groups);
            return;
        }
        groups.push_back({node.bounds, {order_.begin() + node.first, order_.begin() + node.end}});
    }

    const std::vector<Bounds>& boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    std::uint32_t in_leaf_ = 1;
};

}  // namespace

double surface_of(const Bounds& box) {
    if (box.empty()) return 0.0;
    const Vec3 size = box.high - box.low;
    return 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

std::vector<BoxGroup> group_boxes(const std::vector<Bounds>& boxes, std::size_t most) {
    return Tree(boxes).cut(most);
}

}  // namespace dewbow::caustics
