// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light of a beam: a point of its disc.

#include "dewbow/render/caustics/grouped_emission.h"

namespace dewbow::caustics {

class BeamEmission final : public GroupedEmission {
public:
    BeamEmission(const Beam& beam, int index, const Aims& aims);

private:
    std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const override;
    std::optional<Place> place_towards(int target, const Ray& ray) const override;
    double brightness(const EmittedRay& ray) const override;

    /// The point of the disc's plane from which the line through `point` comes.
    Vec3 start_of(Vec3 point) const;
    bool carries(Vec3 start) const;

    const BeamLight& beam_;
    Ball disc_;  ///< centre and radius
    double brightness_;
    /// One a target: whether its own silhouette is smaller than the disc. Where the disc is smaller
    /// than all of them it is the only one.
    std::vector<bool> by_group_;
};

}  // namespace dewbow::caustics
