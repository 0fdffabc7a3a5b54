// SPDX-License-Identifier: Apache-2.0
#pragma once

// How much of the light that meets a drop leaves it between two angles, by rays and without any
// sampling: ε² 2b db is integrated between the impact parameters that belong to the edges of a
// cell, branch by branch. Cells that hold a bow, 0° or 180° are as exact as others.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/geometric_rays.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Parts of the flux of light polarised perpendicular and parallel to the scattering plane.
using PolarisedFlux = Intensities;

/// Edges of the cells of ScatteringModel::intensities: 0°, halfway between neighbours, 180°.
/// Throws InputError unless `theta` ascends strictly within 0 to 180°.
std::vector<Angle> cell_edges(std::span<const Angle> theta);

/// Solid angle between two cones, 2π (cos θ1 − cos θ2).
SolidAngle cell_solid_angle(Angle from, Angle to);

/// How the rays that meet a drop are spread over it.
enum class RayDensity {
    even_over_disc,            ///< 2b db: a sphere in parallel light
    even_in_impact_parameter,  ///< db: a disc-shaped drop, as in Musgrave 1989, 4.3.2
};

/// Adds to `out` [edges.size() − 1] the part of the intercepted flux that order p sends between
/// neighbours of `edges` (ascending, within 0 to 180°).
/// Error: 1e-13 of the order's flux, summed over cells. Throws InputError as ray_branches.
void add_geometric_flux(RelativeIndex n, int p, std::span<const Angle> edges,
                        std::span<PolarisedFlux> out,
                        RayDensity density = RayDensity::even_over_disc);

/// What order p takes of the intercepted flux in all, and ∫ cos θ over that flux.
struct OrderFlux {
    PolarisedFlux flux, flux_times_cosine;
};
/// Error: 1e-14. Throws InputError as ray_branches.
OrderFlux order_flux(RelativeIndex n, int p);

/// Where light that leaves a drop at `theta` would leave a sphere, if the drop turns the bow by
/// `shift`: θ − shift, ever less within 30° of 0° and of 180°, which stay where they are.
Angle angle_without_shift(Angle theta, Angle shift);
/// What an intensity of the sphere at angle_without_shift counts at `theta` for the flux to stay
/// what it is: ratio of the solid angles. Within 20° of shift, beyond which 0 may come out.
double brightness_of_shift(Angle theta, Angle shift);

}  // namespace dewbow
