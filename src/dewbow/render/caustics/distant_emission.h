// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from infinitely far: a direction, then a place on the silhouette that a group of casters
// shows to it.

#include "dewbow/render/caustics/grouped_emission.h"

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

class DistantEmission final : public GroupedEmission {
public:
    /// All must outlive this.
    DistantEmission(const InfiniteLight& light, int index, const std::vector<CasterBounds>& groups,
                    const Outside& outside);

    int dimensions() const override { return light_.parallel() ? 2 : 4; }

private:
    std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const override;
    std::optional<Place> place_towards(int target, const Ray& ray) const override;
    double brightness(const EmittedRay& ray) const override;

    const InfiniteLight& light_;
    const Outside& outside_;
};

}  // namespace dewbow::caustics
