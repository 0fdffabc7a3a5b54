// SPDX-License-Identifier: Apache-2.0
#pragma once

// A polariser before a camera.

#include "dewbow/base/quantity.h"
#include "dewbow/math/transform.h"

namespace dewbow {

/// Share that it lets through of light without polarisation.
inline constexpr double kPolariserShare = 0.5;

/// An ideal sheet before the lens. Light polarised along its axis goes through, which for light
/// that comes aslant is the axis as seen along the line of sight.
class Polariser {
public:
    /// @param turned  from the camera's +y, counterclockwise as the camera sees it.
    /// @param around  it turns with each line of sight (a panorama), so that the axis is turned
    /// from where +y is seen.
    Polariser(Angle turned, const Transform<World, Camera>& world_from_camera, bool around);

    /// Of sunlight that drops scatter towards the eye, the share of the light polarised
    /// perpendicular to the plane of scattering that goes through: cos² of the angle between that
    /// direction, s = v × t, and the axis a, both as seen along v. 1 minus it of the parallel
    /// light. 1/2 where there is no such plane.
    /// @param view  v, from the eye to the drop.   @param to_sun  t.   Both of unit length.
    double perpendicular_share(Vec3 view, Vec3 to_sun) const;

private:
    Vec3 axis_, up_;  ///< up_: +y of the camera; unit
    double cosine_, sine_;
    bool around_;
};

}  // namespace dewbow
