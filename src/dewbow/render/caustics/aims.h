// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the maps of all lamps share: the groups of casters, and where rays from infinitely far
// begin.

#include <vector>

#include "dewbow/render/caustics/casters.h"
#include "dewbow/render/caustics/group_index.h"

namespace dewbow::caustics {

/// Where rays from infinitely far begin: before everything that there is.
class Outside {
public:
    explicit Outside(const Scene& scene);
    /// A point from which a ray along `direction` through `point` meets all that lies on the line.
    Vec3 before(Vec3 point, Vec3 direction) const;

private:
    Ball ball_;  ///< around all shapes but planes
    std::vector<EndlessPlane> planes_;
};

/// Immutable.
struct Aims {
    /// @param casters  outlive this.   @param lamps  how many there are.
    Aims(const Scene& scene, const Casters& casters, std::size_t lamps);

    const std::vector<CasterBounds>& groups;
    GroupIndex index;
    Outside outside;
    /// Rays that are looked at for each lamp and group, to tell what the one sends to the other.
    int looks;
};

}  // namespace dewbow::caustics
