// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light of a point, a spot or a photometric profile: a direction.

#include "dewbow/render/caustics/directions_to.h"
#include "dewbow/render/caustics/grouped_emission.h"

namespace dewbow::caustics {

class PointEmission final : public GroupedEmission {
public:
    PointEmission(const PunctualLight& light, int index, const Aims& aims);

private:
    std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const override;
    std::optional<Place> place_towards(int target, const Ray& ray) const override;
    double brightness(const EmittedRay& ray) const override;

    const PunctualLight& light_;
    Vec3 position_;
    double brightness_;
    Dir<World> axis_;  ///< of the cone that the light shines into
    double width_;     ///< 1 − cos of its half angle
    /// One a target; nothing: the cone. Where the cone is narrower than all of them it is the only
    /// one.
    std::vector<std::optional<DirectionsTo>> to_;
};

}  // namespace dewbow::caustics
