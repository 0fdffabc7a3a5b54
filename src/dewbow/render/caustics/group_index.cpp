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
    std::vector<std::uint32_t> members;
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        boxes.push_back(groups[i].box());
        (groups[i].endless() ? endless_ : members).push_back(i);
    }
    tree_ = BoundsTree(boxes, std::move(members), kMostInLeaf);
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
        return entry(tree_.nodes[node].bounds, origin, inverse, from);
    };
    if (!tree_.nodes.empty()) visit(0, entry_of(0));
    while (count > 0) {
        const auto [at, in] = pending[--count];
        if (in > nearest.limit()) continue;
        const BoundsTree::Node& node = tree_.nodes[at];
        if (node.right) {
            // The nearer one is looked at first.
            const double left = entry_of(at + 1), right = entry_of(node.right);
            if (left < right) visit(node.right, right);
            visit(at + 1, left);
            if (!(left < right)) visit(node.right, right);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            nearest.look_at(tree_.order[i], groups_[tree_.order[i]], origin, direction, from);
    }
    return nearest.t < kInfinity ? int(nearest.group) : -1;
}

}  // namespace dewbow::caustics
