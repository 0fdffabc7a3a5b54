// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sight_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

constexpr int kSightSteps = 72;

// The table of the sun's masses: heights as the cube of even numbers, altitudes even.
constexpr int kHeights = 48, kAltitudes = 73;
constexpr double kAltitudeStep = 0.25 * std::numbers::pi / 180.0;
/// Kept off the logarithm's end.
constexpr double kLeastMass = 1e-9;

AirParts log_of(AirParts m) {
    return {std::log(m.air + kLeastMass), std::log(m.haze + kLeastMass),
            std::log(m.ozone + kLeastMass)};
}

}  // namespace

std::vector<SightStep> sight_line(double sin_elevation) {
    const double along = kSkyRadius_m * sin_elevation;
    const double top = kSkyRadius_m + kSkyTop_m;
    const double end = std::sqrt(top * top - kSkyRadius_m * kSkyRadius_m + along * along) - along;
    const double cos_elevation = std::sqrt(1.0 - sin_elevation * sin_elevation);
    std::vector<SightStep> steps(kSightSteps);
    AirParts passed;
    for (int k = 0; k < kSightSteps; ++k) {
        // Steps grow as cubes: most of what is seen is near.
        const double u = (k + 0.5) / kSightSteps;
        SightStep& step = steps[k];
        step.distance_m = end * u * u * u;
        const double s = step.distance_m;
        const double r = std::sqrt(kSkyRadius_m * kSkyRadius_m + s * (s + 2.0 * along));
        step.height_m = s * (s + 2.0 * along) / (r + kSkyRadius_m);
        step.sin_altitude = (along + s) / r;
        step.level_angle = std::asin(s * cos_elevation / r);
        step.step_mass = (3.0 * u * u * end / kSightSteps) * air_density(step.height_m);
        step.mass = passed + 0.5 * step.step_mass;
        passed = passed + step.step_mass;
    }
    return steps;
}

SunMasses::SunMasses(double sun_altitude)
    : first_altitude_(sun_altitude - kAltitudeStep * (kAltitudes / 2)) {
    log_mass_.reserve(kHeights * kAltitudes);
    for (int i = 0; i < kHeights; ++i) {
        const double v = static_cast<double>(i) / (kHeights - 1);
        for (int j = 0; j < kAltitudes; ++j)
            log_mass_.push_back(log_of(air_mass_to_space(
                kSkyTop_m * v * v * v, std::sin(first_altitude_ + kAltitudeStep * j))));
    }
}

AirParts SunMasses::at(double height_m, double sin_sun) const {
    const double y =
        std::clamp(std::cbrt(height_m / kSkyTop_m) * (kHeights - 1), 0.0, kHeights - 1.000001);
    const double x =
        std::clamp((std::asin(std::clamp(sin_sun, -1.0, 1.0)) - first_altitude_) / kAltitudeStep,
                   0.0, kAltitudes - 1.000001);
    const int i = static_cast<int>(y), j = static_cast<int>(x);
    const double ty = y - i, tx = x - j;
    const AirParts* at = &log_mass_[i * kAltitudes + j];
    const AirParts m = (1.0 - ty) * ((1.0 - tx) * at[0] + tx * at[1]) +
                       ty * ((1.0 - tx) * at[kAltitudes] + tx * at[kAltitudes + 1]);
    return {std::exp(m.air), std::exp(m.haze), std::exp(m.ozone)};
}

}  // namespace dewbow
