// SPDX-License-Identifier: Apache-2.0
#pragma once

// Newton's experiment by quadrature: the sun's disc shines through a slit and a prism onto a wall.
// Where each wavelength falls, and how much of it, by closed forms alone: Snell's and Fresnel's
// laws at two planes, Beer and Lambert's between them, Gauss's rule over the slit and the sun. It
// shares no code with what traces rays.

#include <array>

#include "dewbow/math/vector.h"

namespace dewbow::kit {

/// The frame of shape `Prism`: along z, apex at +y, centroid at the origin. The sun's middle comes
/// in from the left, rising, meets the left face at its middle, and a ray of `index_between` goes
/// through at minimum deviation. The slit faces the sun, its height is along z. The wall stands at
/// right angles to that ray.
struct NewtonsExperiment {
    double apex_rad = 1.0471975511965976;  // 60°
    double side = 0.05, length = 0.05;     // m, of the prism
    double index_between = 1.785;          // relative to the air around
    double sun_radius_rad = 0.2666 * 0.017453292519943295;
    double slit_width = 0.002, slit_height = 0.015;  // m
    double slit_distance = 0.05;                     // m, from the face along the ray
    double wall_distance = 2.0;                      // m, from where that ray leaves the prism

    double incidence_rad() const;  ///< of the sun's middle
    Vec3 sunward() const;          ///< the direction in which the sun's light travels
    Vec3 slit_centre() const;
    Vec3 across_slit() const;  ///< unit vector along its width
    Vec3 onward() const;       ///< the direction in which the ray between leaves
    Vec3 wall_centre() const;
    Vec3 along_wall() const;  ///< unit vector that points to larger deviations
};

/// What of one wavelength arrives on the wall.
struct SpotOnWall {
    double power = 0.0;       ///< m²: W nm⁻¹ for a sun of 1 W m⁻² nm⁻¹
    double u = 0.0, v = 0.0;  ///< m, its centroid: along_wall() and along z
};

/// @param n  index of the glass relative to the air.  @param absorption_per_m  of the glass.
/// Throws std::logic_error if any ray misses one of the two faces. Error: below 1e-9 for what the
/// tests ask, by comparison with twice the nodes.
SpotOnWall spot_on_wall(const NewtonsExperiment& setup, double n, double absorption_per_m,
                        int nodes = 12);

/// Index of N-SF11 relative to air of 20 °C. [Schott's Sellmeier coefficients, 2017]
double n_sf11(double vacuum_nm);

}  // namespace dewbow::kit
