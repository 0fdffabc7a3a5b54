// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light of a glowing shape: a point of its surface, then a direction from there.

#include "dewbow/render/caustics/grouped_emission.h"

namespace dewbow::caustics {

class SurfaceEmission final : public GroupedEmission {
public:
    SurfaceEmission(const GlowingShape& shape, int index, const Aims& aims);

private:
    std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const override;
    std::optional<Place> place_towards(int target, const Ray& ray) const override;
    double brightness(const EmittedRay& ray) const override;

    /// The part of a ball from which a target can be seen: where the normal lies in a cone. Chosen
    /// in proportion to a bound on the cosine with which the target is seen, or all alike.
    struct Cap {
        Dir<World> axis;
        double width;  ///< 1 − cos of its half angle
        bool alike;

        Vec3 sample(std::array<double, 2> u) const;
        /// Density per sr of normals.
        SquarePlace place_of(Vec3 normal) const;
        double density(double v) const;
    };
    Cap cap_towards(const CasterBounds& target) const;
    double weight(int part, const CasterBounds& target) const;
    const Distribution1D& parts(int target) const {
        return parts_[parts_.size() == 1 ? 0 : std::size_t(target)];
    }
    GlowingShape::SurfacePoint point_of(int target, int part, std::array<double, 2> u) const;
    SquarePlace place_of(int target, int part, Vec3 point) const;

    const GlowingShape& shape_;
    std::optional<GlowingShape::WorldBall> ball_;
    std::vector<Cap> caps_;              ///< of a ball: one a target
    std::vector<Distribution1D> parts_;  ///< one a target, or one for all
};

}  // namespace dewbow::caustics
