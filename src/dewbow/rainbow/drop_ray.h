// SPDX-License-Identifier: Apache-2.0
#pragma once

// A ray through a spherical drop of real index: where it goes and what is left of it.

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

/// Angles of a ray of impact parameter b (in radii, 0 to 1): sin i = b, sin i = n sin r.
struct DropRay {
    Angle incidence, refraction;
};
DropRay drop_ray(double b, RelativeIndex n);

/// Deflection of light of order p, D = (p − 1)π + 2i − 2pr; not wrapped: it can exceed 180°, and
/// for p = 0 it is negative.                            [Musgrave 1989, 4.3.2; Descartes 1637]
Angle deviation(const DropRay& ray, int p);

/// The scattering angle, 0 to 180°, of a ray deflected by D.
Angle scattering_angle(Angle deviation);

/// dD/db in radians, infinite at b = 1: 2 / cos i − 2p / (n cos r).
double deviation_slope(const DropRay& ray, RelativeIndex n, int p);

/// What is left of the two polarisations' amplitudes: r outside for p = 0, else
/// (1 − r²)(−r)^{p−1}, with r_s = −sin(i−r)/sin(i+r), r_p = tan(i−r)/tan(i+r).
struct RayAmplitudes {
    double perpendicular, parallel;
};
RayAmplitudes ray_amplitudes(const DropRay& ray, RelativeIndex n, int p);

/// The ray of order p >= 2 whose deflection is least: there light piles up into a bow.
struct DescartesRay {
    int p = 2;
    DropRay ray;
    double impact_parameter = 0.0;  ///< sin i = √((p² − n²) / (p² − 1))
    Angle deviation;
    Angle scattering_angle;
    /// +1 where the bright side lies at larger scattering angles (p = 2), −1 where at smaller (p =
    /// 3).
    int bright_side = 1;
    double airy_constant = 0.0;  ///< h = ½ d²D/db²
    /// Of the bow around the antisolar point, 180° − scattering angle.
    Angle radius() const { return 180.0 * unit::deg - scattering_angle; }
};
/// cos i = √((n² − 1) / (p² − 1)), tan i = p tan r, h = ((p²−1)²/p²) √((p²−n²)/(n²−1)³).
/// Throws InputError unless p >= 2 and 1 < n < p.                    [van de Hulst 1957, §13.2]
DescartesRay descartes_ray(RelativeIndex n, int p);

}  // namespace dewbow
