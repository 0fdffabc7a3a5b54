// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lamps of a scene as a ray through haze looks at them: roughly, and all at once.

#include "dewbow/render/haze/distance_density.h"
#include "dewbow/render/light_set.h"

namespace dewbow {

class HazeLamps {
public:
    HazeLamps(const Scene& scene, const LightSet& lights);

    /// Of the ray from `origin` along the unit vector `direction`, up to `length` (m, may be
    /// infinite): about in proportion to the light of all lamps that is scattered into it, were
    /// nothing in between.   @param extinction  m⁻¹, one a lane.
    DistanceDensity density(Vec3 origin, Vec3 direction, double length,
                            std::span<const double> extinction) const;

    /// The same of all lamps that are not infinitely far. With none of them it is empty.
    DistanceDensity near_density(Vec3 origin, Vec3 direction, double length,
                                 std::span<const double> extinction) const;

private:
    /// A lamp or several, with the cone that holds all their light.
    struct Near {
        Vec3 centre;
        double radius;     ///< of a ball around them
        double intensity;  ///< Y
        bool everywhere;   ///< no cone
        Vec3 apex, axis;
        double cosine;  ///< of the cone's half angle, at least 0
    };
    struct Cylinder {
        Vec3 base, axis;
        double radius, irradiance;
    };
    void add(const LightBounds& bounds);
    void add_near(Vec3 origin, Vec3 direction, double length, DistanceDensity& density) const;

    std::vector<Near> near_;
    std::vector<Cylinder> beams_;
    double far_irradiance_;
};

}  // namespace dewbow
