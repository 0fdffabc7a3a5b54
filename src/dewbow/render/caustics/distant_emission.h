// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from infinitely far: a direction, then a place on the silhouette that a group of casters
// shows to it.

#include "dewbow/render/caustics/grouped_emission.h"

namespace dewbow::caustics {

class DistantEmission final : public GroupedEmission {
public:
    DistantEmission(const InfiniteLight& light, int index, const Aims& aims);

private:
    std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const override;
    std::optional<Place> place_towards(int target, const Ray& ray) const override;
    double brightness(const EmittedRay& ray) const override;

    const InfiniteLight& light_;
    const Outside& outside_;  ///< of the aims
};

}  // namespace dewbow::caustics
