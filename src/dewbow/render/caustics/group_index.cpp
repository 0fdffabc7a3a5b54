// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/group_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dewbow::caustics {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kMostInLeaf = 2;
/// Levels of the tree at most: it is cut at medians.
constexpr std::size_t kMostPending = 64;
/// Places nearer together than this share of their distance are one: faces of two boxes in one
/// plane must not be told apart by rounding.
constexpr double kSamePlace = 1e-9;

/// Where a line enters a box, or infinity if it misses it or has left it before `from`.
double entry(const Bounds& box, Vec3 origin, Vec3 inverse, double from) {
    double in = from, out = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.low[axis] - origin[axis]) * inverse[axis];
        const double b = (box.high[axis] - origin[axis]) * inverse[axis];
        // Not a number where 0 times infinity: then the other operand stays.
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    const double slack = kSamePlace * (std::abs(out) + 1.0);
    return in <= out + slack ? in : kInfinity;
}

/// The nearest group so far.
struct Nearest {
    double t = kInfinity;
    std::uint32_t group = 0;

    double limit() const { return t + slack(); }
    double slack() const { return t < kInfinity ? kSamePlace * (std::abs(t) + 1.0) : 0.0; }
    void look_at(std::uint32_t i, const CasterBounds& body, Vec3 origin, Vec3 direction,
                 double from) {
        const auto crossing = body.crossing(origin, direction);
        if (!crossing || crossing->t_out <= from) return;
        const double at = std::max(from, crossing->t_in);
        if (at < t - slack()) {
            t = at, group = i;
        } else if (at <= limit() && i < group) {
            t = std::min(t, at), group = i;
        }
    }
};

}  // namespace

GroupIndex::GroupIndex(const std::vector<CasterBounds>& groups) : groups_(groups) {
    std::vector<Bounds> boxes;
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        boxes.push_back(groups[i].box());
        (groups[i].endless() ? endless_ : order_).push_back(i);
    }
    if (!order_.empty()) build(0, std::uint32_t(order_.size()), boxes);
}

/// The node of order_[first, end). Returns its index.
std::uint32_t GroupIndex::build(std::uint32_t first, std::uint32_t end,
                                const std::vector<Bounds>& boxes) {
    const auto node = std::uint32_t(nodes_.size());
    nodes_.push_back({{}, first, end - first, 0});
    Bounds bounds, centres;
    for (std::uint32_t i = first; i < end; ++i) {
        const Bounds& box = boxes[order_[i]];
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
                         return boxes[a].centre()[axis] < boxes[b].centre()[axis];
                     });
    build(first, middle, boxes);
    nodes_[node].right = build(middle, end, boxes);
    return node;
}

int GroupIndex::first_on_line(Vec3 origin, Vec3 direction) const {
    return first(origin, direction, -kInfinity);
}

int GroupIndex::first(Vec3 origin, Vec3 direction, double from) const {
    const Vec3 inverse{1.0 / direction.x, 1.0 / direction.y, 1.0 / direction.z};
    Nearest nearest;
    for (const std::uint32_t i : endless_) nearest.look_at(i, groups_[i], origin, direction, from);
    struct Pending {
        std::uint32_t node;
        double in;
    };
    std::array<Pending, kMostPending> pending;
    std::size_t count = 0;
    const auto visit = [&](std::uint32_t node, double in) {
        if (in < kInfinity) pending[count++] = {node, in};
    };
    const auto entry_of = [&](std::uint32_t node) {
        return entry(nodes_[node].bounds, origin, inverse, from);
    };
    if (!nodes_.empty()) visit(0, entry_of(0));
    while (count > 0) {
        const auto [at, in] = pending[--count];
        if (in > nearest.limit()) continue;
        const Node& node = nodes_[at];
        if (node.right) {
            // The nearer one is looked at first.
            const double left = entry_of(at + 1), right = entry_of(node.right);
            if (left < right) visit(node.right, right);
            visit(at + 1, left);
            if (!(left < right)) visit(node.right, right);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            nearest.look_at(order_[i], groups_[order_[i]], origin, direction, from);
    }
    return nearest.t < kInfinity ? int(nearest.group) : -1;
}

}  // namespace dewbow::caustics
