// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays that leave the lamps of a scene of caustics, evenly over lamp and gate. A gate is a
// rectangle through which light reaches the bodies: it says where to look closely, and nothing
// more, for all other rays are drawn as well.

#include <array>

#include "things.h"

namespace dewbow::bench {

struct EmittedRay {
    Vec3 origin, d;       ///< m; unit vector
    double weight = 0.0;  ///< flux per number of rays drawn, over the source's spectrum (in W m⁻²
                          ///< sr⁻¹ nm⁻¹, W sr⁻¹ nm⁻¹ or W m⁻² nm⁻¹); may be 0
    int source = 0;  ///< counts lamps, then spots, then suns
};

class Emission {
public:
    /// Finds a gate for each source: what holds the bodies as it sees them, narrowed down to where
    /// rays arrive.
    Emission(const PlainScene& scene, const Things& things);

    /// A ray through the gate; u uniform in [0, 1)⁴.
    EmittedRay through_gate(int source, const std::array<double, 4>& u) const;
    /// Any ray that the source gives off, of weight 0 where it goes through the gate.
    EmittedRay elsewhere(int source, const std::array<double, 4>& u) const;

private:
    struct Gate {
        Vec3 centre, half_u, half_v;  ///< m
        Vec3 normal() const { return normalised(cross(half_u, half_v)); }
        double area_m2() const { return 4.0 * length(cross(half_u, half_v)); }
        Vec3 at(double s, double t) const { return centre + half_u * s + half_v * t; }
        bool holds(Vec3 origin, Vec3 d) const;
    };
    Gate first_gate(int source) const;
    Gate narrower(int source) const;

    const PlainScene& scene_;
    const Things& things_;
    std::vector<Gate> gates_;
};

/// Even in the unit disc.
std::array<double, 2> point_in_disc(double u, double v);
/// Even over a lamp.
Vec3 point_of(const PlainLamp& lamp, double u, double v);
double area_m2(const PlainLamp& lamp);
/// In which the sun's light travels: even in the disc that its directions are seen as along its
/// axis, so that their density is cos θ / (π sin² radius).
Vec3 direction_from(const PlainSun& sun, double u, double v);

}  // namespace dewbow::bench
