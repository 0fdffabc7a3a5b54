// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/learnt_density.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/check.h"

namespace dewbow::caustics {

/// The room that a box takes, and what lies in it.
struct LearntDensity::Part {
    double volume;
    double probability;
    AimPoint low, high;
};

namespace {

std::uint64_t sum_of_masses(const std::vector<LearntDensity::Box>& boxes) {
    std::uint64_t sum = 0;
    for (const LearntDensity::Box& box : boxes)
        if (box.axis < 0) {
            DEWBOW_CHECK(sum + box.mass >= sum, "masses of a density add up to less than 2^64");
            sum += box.mass;
        }
    return sum;
}

}  // namespace

LearntDensity::LearntDensity(const std::vector<Box>& boxes) : nodes_(boxes.size()) {
    Part whole{1.0, 1.0, {}, {}};
    whole.high.fill(1.0);
    add(boxes, 0, whole, sum_of_masses(boxes));
}

/// Makes the node of the box `at` and all below. @param room  its bounds.
/// @return  its volume and probability.
LearntDensity::Part LearntDensity::add(const std::vector<Box>& boxes, std::size_t at,
                                       const Part& room, std::uint64_t all_masses) {
    const Box& box = boxes[at];
    Part part = room;
    if (box.axis < 0) {
        part.volume = 1.0;
        for (std::size_t k = 0; k < kAimDimensions; ++k) part.volume *= room.high[k] - room.low[k];
        const double learnt = all_masses ? double(box.mass) / double(all_masses) : part.volume;
        part.probability = kUniformShare * part.volume + (1.0 - kUniformShare) * learnt;
        nodes_[at] = {0.0, part.probability / part.volume, 0, 0};
        return part;
    }
    const auto axis = std::size_t(box.axis);
    DEWBOW_CHECK(room.low[axis] < box.cut && box.cut < room.high[axis], "a cut lies in its box");
    Part below = room, above = room;
    below.high[axis] = above.low[axis] = box.cut;
    below = add(boxes, at + 1, below, all_masses);
    above = add(boxes, box.second, above, all_masses);
    part.volume = below.volume + above.volume;
    part.probability = below.probability + above.probability;
    nodes_[at] = {box.cut, below.probability / part.probability, box.second, box.axis};
    return part;
}

LearntDensity::Sample LearntDensity::sample(const AimPoint& u) const {
    AimPoint within = u, low{}, high;
    high.fill(1.0);
    const Node* node = nodes_.data();
    while (node->second) {
        const auto axis = std::size_t(node->axis);
        double& t = within[axis];
        const double share = node->value;
        if (t < share) {
            t /= share;
            high[axis] = node->cut;
            ++node;
        } else {
            t = (t - share) / (1.0 - share);
            low[axis] = node->cut;
            node = &nodes_[node->second];
        }
    }
    Sample sample{{}, node->value};
    for (std::size_t k = 0; k < kAimDimensions; ++k) {
        const double at = low[k] + (high[k] - low[k]) * within[k];
        sample.at[k] = at < high[k] ? at : std::nextafter(high[k], 0.0);  // rounded up to the edge
    }
    return sample;
}

double LearntDensity::density(const AimPoint& at) const {
    const Node* node = nodes_.data();
    while (node->second)
        node = at[std::size_t(node->axis)] < node->cut ? node + 1 : &nodes_[node->second];
    return node->value;
}

}  // namespace dewbow::caustics
