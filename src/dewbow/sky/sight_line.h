// SPDX-License-Identifier: Apache-2.0
#pragma once

// A line of sight from the ground out of the air, cut into steps, and the sun as seen from it.

#include <vector>

#include "dewbow/sky/air_column.h"

namespace dewbow {

/// A step of a line of sight.
struct SightStep {
    double distance_m;    ///< from the eye
    double height_m;      ///< above the ground below it
    double sin_altitude;  ///< of the line above the level there
    double level_angle;   ///< radians over the sphere from the eye: how much the level has tilted
    AirParts mass;        ///< relative masses from the eye to the step
    AirParts step_mass;   ///< of the step itself
};

/// A straight line over a sphere of radius kSkyRadius_m, out of the air or down to the ground.
struct SightLine {
    std::vector<SightStep> steps;
    AirParts mass;  ///< of the whole
    bool to_ground = false;
};

/// @param eye_m  height of the eye, 0 to kSkyTop_m.   @param sin_elevation  at the eye, −1 to 1.
SightLine sight_line(double eye_m, double sin_elevation);

/// How far the horizon lies below the level of an eye, radians; 0.95° at 1 km.
double dip_of_horizon(double eye_m);

/// Masses towards the sun from every place that lines of sight from one eye near the ground pass.
/// A table by height and local altitude of the sun; error 0.3 %.
class SunMasses {
public:
    /// @param sun_altitude  at the eye, radians, 0 to π/2.
    explicit SunMasses(double sun_altitude);
    /// @param sin_sun  sine of the sun's altitude above the local level, within what the sphere
    /// allows (9°) of that at the eye.
    AirParts at(double height_m, double sin_sun) const;

private:
    double first_altitude_;           ///< radians
    std::vector<AirParts> log_mass_;  ///< [height][altitude]
};

}  // namespace dewbow
