// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "dewbow/base/error.h"
#include "dewbow/render/light_tree.h"
#include "dewbow/render/light_tree_limits.h"

namespace dewbow {

struct LightTree::Item {
    LightBounds bounds;
    Vec3 centre;
    std::uint32_t light;
};

class LightTree::Builder {
public:
    Builder(LightTree& tree, double whole) : tree_(tree), whole_(whole) {}

    void add(std::span<Item> items, int depth, std::uint64_t way);

private:
    Node node_of(const LightBounds& bounds) const;

    LightTree& tree_;
    const double whole_;  ///< intensity of all
};

namespace {

/// Slabs in which splits are tried along each axis.
constexpr int kSlabs = 12;
constexpr float kLeastShare = std::numeric_limits<float>::min();

/// Grows with the probability that the lights are chosen for nothing: their intensity, the solid
/// angle that they shine into, and the cross-section of their ball.
double cost(const LightBounds& bounds) {
    if (!(bounds.intensity > 0.0)) return 0.0;
    const double radius = bounds.box.radius();
    return bounds.intensity * emission_measure(bounds) * radius * radius;
}

struct Split {
    int axis = -1;  ///< −1: none
    double slabs_per_m = 0.0, low = 0.0;
    int last = 0;  ///< slab of the first half

    int slab_of(Vec3 centre) const {
        return std::min(kSlabs - 1, int((centre[axis] - low) * slabs_per_m));
    }
};

/// The split of least cost between slabs of equal width along `axis`, if it is below `best`.
template <class Items>
void try_axis(const Items& items, int axis, const Bounds& centres, Split& split, double& best) {
    const double width = centres.high[axis] - centres.low[axis];
    if (!(width > 0.0)) return;
    Split here{axis, kSlabs / width, centres.low[axis], 0};
    if (!std::isfinite(here.slabs_per_m)) return;
    std::array<LightBounds, kSlabs> slabs;
    for (const auto& item : items) {
        LightBounds& slab = slabs[std::size_t(here.slab_of(item.centre))];
        slab = join(slab, item.bounds);
    }
    std::array<double, kSlabs> above{};  // cost of the slabs from the i-th on
    LightBounds sum;
    for (std::size_t i = kSlabs - 1; i > 0; --i) above[i] = cost(sum = join(sum, slabs[i]));
    sum = {};
    for (std::size_t i = 0; i + 1 < kSlabs; ++i) {
        sum = join(sum, slabs[i]);
        const double total = cost(sum) + above[i + 1];
        if (!(total < best)) continue;
        best = total;
        split = here;
        split.last = int(i);
    }
}

/// Parts `items` in two that are not empty; returns the size of the first.
template <class Items>
std::size_t part(Items items, int depth) {
    Bounds centres;
    for (const auto& item : items) centres.add(item.centre);
    Split split;
    double best = std::numeric_limits<double>::infinity();
    if (depth < light_tree::kDeepest)
        for (int axis = 0; axis < 3; ++axis) try_axis(items, axis, centres, split, best);
    if (split.axis >= 0) {
        const auto middle = std::partition(items.begin(), items.end(), [&](const auto& item) {
            return split.slab_of(item.centre) <= split.last;
        });
        const std::size_t first = std::size_t(middle - items.begin());
        if (first > 0 && first < items.size()) return first;
    }
    return items.size() / 2;  // all in one place, or deep: by their order
}

}  // namespace

LightTree::Node LightTree::Builder::node_of(const LightBounds& bounds) const {
    constexpr float kEnd = std::numeric_limits<float>::infinity();
    Node node{};
    const Vec3 centre = bounds.box.centre();
    for (int i = 0; i < 3; ++i) node.centre[i] = float(centre[i]);
    const Vec3 rounded{node.centre[0], node.centre[1], node.centre[2]};
    const double radius = bounds.box.radius() + length(rounded - centre);
    node.radius = std::nextafter(float(radius), kEnd);
    for (int i = 0; i < 3; ++i) node.axis[i] = float(bounds.normals.axis[i]);
    const double normals =
        std::min(bounds.normals.half_angle_rad + light_tree::kRim, std::numbers::pi);
    node.cos_normals = float(std::cos(normals));
    node.sin_normals = float(std::sin(normals));
    node.cos_emission =
        float(std::cos(std::min(bounds.emission_rad + light_tree::kRim, std::numbers::pi)));
    node.intensity = std::max(float(bounds.intensity / whole_), kLeastShare);
    node.two_sided = bounds.two_sided;
    return node;
}

void LightTree::Builder::add(std::span<Item> items, int depth, std::uint64_t way) {
    LightBounds all;
    for (const Item& item : items) all = join(all, item.bounds);
    const std::size_t at = tree_.nodes_.size();
    tree_.nodes_.push_back(node_of(all));
    if (items.size() == 1) {
        tree_.nodes_[at].light = items[0].light;
        tree_.ways_[items[0].light] = way;
        return;
    }
    const std::size_t first = part(items, depth);
    add(items.first(first), depth + 1, way);
    tree_.nodes_[at].second = std::uint32_t(tree_.nodes_.size());
    add(items.subspan(first), depth + 1, way | std::uint64_t{1} << depth);
}

LightTree::LightTree(const std::vector<LightBounds>& lights)
    : ways_(lights.size(), light_tree::kNowhere) {
    if (lights.size() > std::size_t(light_tree::kMostLights))
        throw InputError(
            fmt::format("the scene has {} lights and glowing triangles; at most {} are "
                        "sampled",
                        lights.size(), light_tree::kMostLights),
            "let a coarser mesh glow");
    std::vector<Item> items;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!(lights[i].intensity > 0.0)) continue;
        items.push_back({lights[i], lights[i].box.centre(), std::uint32_t(i)});
        intensity_ += lights[i].intensity;
    }
    if (items.empty()) return;
    nodes_.reserve(2 * items.size() - 1);
    Builder(*this, intensity_).add(items, 0, 0);
}

}  // namespace dewbow
