// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which group of casters a ray meets first: by a tree of boxes, so that ten thousand groups
// cost little more than ten.

#include <cstdint>
#include <vector>

#include "dewbow/render/bounds_tree.h"
#include "dewbow/render/caustics/caster_bounds.h"

namespace dewbow::caustics {

class GroupIndex {
public:
    /// `groups` must outlive this.
    explicit GroupIndex(const std::vector<CasterBounds>& groups);

    /// The group that a ray meets first, −1 for none. One that holds the origin is met there; of
    /// several that are met at one place it is the first.
    int first_from(Vec3 origin, Vec3 direction) const { return first(origin, direction, 0.0); }
    /// The same for a ray from infinitely far, of which `origin` is any point.
    int first_on_line(Vec3 origin, Vec3 direction) const;

private:
    int first(Vec3 origin, Vec3 direction, double from) const;

    const std::vector<CasterBounds>& groups_;
    std::vector<std::uint32_t> endless_;
    BoundsTree tree_;  ///< of the others
};

}  // namespace dewbow::caustics
