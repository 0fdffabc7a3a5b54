// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/air_column.h"

#include <cmath>
#include <numbers>

#include "dewbow/sky/sunlight.h"

namespace dewbow {
namespace {

// U.S. Standard Atmosphere 1976: sea level, lapse to the tropopause, M g / R.
constexpr double kGround_K = 288.15, kLapse_K_per_m = 6.5e-3, kTropopause_m = 11e3;
constexpr double kTropopause_K = kGround_K - kLapse_K_per_m * kTropopause_m;
constexpr double kHydrostatic_K_per_m = 0.0341632;
/// Pressure at the tropopause over that on the ground.
constexpr double kTropopausePressure = 0.223361;

constexpr double kOzoneHeight_m = 22e3, kOzoneHalfWidth_m = 15e3;

/// Half the steps along a ray that is cut where it is lowest.
constexpr int kSteps = 48;

double pressure_over_ground(double height_m) {
    if (height_m < kTropopause_m)
        return std::pow(1.0 - kLapse_K_per_m / kGround_K * height_m,
                        kHydrostatic_K_per_m / kLapse_K_per_m);
    return kTropopausePressure *
           std::exp(-kHydrostatic_K_per_m / kTropopause_K * (height_m - kTropopause_m));
}

/// Masses along a straight line from its lowest point, at `lowest` from the sphere's centre, up to
/// the distance `length`. Steps grow as cubes, since most lies low.
AirParts mass_from_lowest(double lowest, double from, double to) {
    AirParts sum;
    // s = from + (to − from) u³
    for (int k = 0; k < kSteps; ++k) {
        const double u = (k + 0.5) / kSteps;
        const double s = from + (to - from) * u * u * u;
        const double height =
            s * s / (std::sqrt(lowest * lowest + s * s) + lowest) + (lowest - kSkyRadius_m);
        sum = sum + (3.0 * u * u / kSteps * (to - from)) * air_density(height);
    }
    return sum;
}

}  // namespace

AirParts air_density(double height_m) {
    const double h = std::max(height_m, 0.0);
    const double kelvin = h < kTropopause_m ? kGround_K - kLapse_K_per_m * h : kTropopause_K;
    const double off = std::min(std::abs(h - kOzoneHeight_m) / kOzoneHalfWidth_m, 1.0);
    return {pressure_over_ground(h) * kHydrostatic_K_per_m / kelvin,
            std::exp(-h / kHazeScale_m) / kHazeScale_m,
            (0.5 + 0.5 * std::cos(std::numbers::pi * off)) / kOzoneHalfWidth_m};
}

AirParts air_mass_to_space(double height_m, double sin_altitude) {
    const double r = kSkyRadius_m + height_m, top = kSkyRadius_m + kSkyTop_m;
    const double along = r * sin_altitude;  // from the line's lowest point to the start
    const double lowest = std::sqrt(std::max(r * r - along * along, 0.0));
    if (lowest >= top) return {};
    const double end = std::sqrt(top * top - lowest * lowest);
    if (along >= 0.0) return mass_from_lowest(lowest, along, end);
    return mass_from_lowest(lowest, 0.0, -along) + mass_from_lowest(lowest, 0.0, end);
}

double visible_share_of_sun(double height_m, double sin_altitude) {
    constexpr double kRadius = kSunRadius.to(unit::rad);
    const double dip = std::acos(kSkyRadius_m / (kSkyRadius_m + height_m));
    const double above = (std::asin(std::clamp(sin_altitude, -1.0, 1.0)) + dip) / kRadius;
    if (above >= 1.0) return 1.0;
    if (above <= -1.0) return 0.0;
    // A disc cut by a straight edge.
    return 0.5 + (std::asin(above) + above * std::sqrt(1.0 - above * above)) / std::numbers::pi;
}

}  // namespace dewbow
