// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lights without extent: points, spots, photometric profiles, beams. From one place each is seen in
// one direction, or not at all.

#include <optional>

#include "dewbow/render/light_bounds.h"
#include "dewbow/render/receiver.h"

namespace dewbow {

/// How a light without extent arrives at a point.
struct Arrival {
    Vec3 direction;   ///< towards the light, unit
    double distance;  ///< to it, m
    /// What the light's spectrum is multiplied with to be the irradiance on a surface that faces
    /// the light; > 0.
    double factor;
};

/// A PointLight, SpotLight or ProfileLight.
class PunctualLight {
public:
    static bool holds(const Light& light);
    explicit PunctualLight(const Light& light);

    /// Nothing where it gives no light.
    std::optional<Arrival> arrival(Vec3 at) const;
    Vec3 position() const;
    /// What the spectrum is multiplied with to be the intensity into a direction; may be 0.
    double factor(Vec3 leaving) const;
    LightBounds bounds() const;
    const Spectrum& spectrum() const;

private:
    std::variant<PointLight, SpotLight, ProfileLight> light_;
    double cos_outer_ = 0.0, per_cosine_ = 0.0;  ///< of a spot
};

class Beam {
public:
    explicit Beam(const BeamLight& light);

    /// Nothing outside of the cylinder. The distance is that to the disc.
    std::optional<Arrival> arrival(Vec3 at) const;
    /// Brightness of the irradiance at `receiver`; 0 where it gives none.
    double irradiance(const Receiver& receiver) const;
    const Spectrum& spectrum() const { return *light_.irradiance; }
    const BeamLight& light() const { return light_; }

private:
    BeamLight light_;
    double radius2_m2_, brightness_;
};

}  // namespace dewbow
