// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sight_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

constexpr int kRisingSteps = 72, kFallingSteps = 48;

// The table of the sun's masses: heights as the cube of even numbers, altitudes even.
constexpr int kHeights = 48, kAltitudes = 73;
constexpr double kAltitudeStep = 0.25 * std::numbers::pi / 180.0;
/// Kept off the logarithm's end.
constexpr double kLeastMass = 1e-9;

/// Cuts a line into steps.
struct Walker {
    double radius;         ///< of the eye, m
    double along;          ///< from the line's lowest point to the eye, m
    double cos_elevation;  ///< at the eye

    void add_step(double s, double length, SightLine& line) const {
        const double r = std::sqrt(radius * radius + s * (s + 2.0 * along));
        SightStep step;
        step.distance_m = s;
        step.height_m = std::max(radius - kSkyRadius_m + s * (s + 2.0 * along) / (r + radius), 0.0);
        step.sin_altitude = (along + s) / r;
        step.level_angle = std::asin(std::min(s * cos_elevation / r, 1.0));
        step.step_mass = length * air_density(step.height_m);
        step.mass = line.mass + 0.5 * step.step_mass;
        line.mass = line.mass + step.step_mass;
        line.steps.push_back(step);
    }
    /// Steps grow as cubes: most of what is seen is near the start.
    void add_rising(double from, double to, SightLine& line) const {
        for (int k = 0; k < kRisingSteps; ++k) {
            const double u = (k + 0.5) / kRisingSteps;
            add_step(from + (to - from) * u * u * u, (to - from) * 3.0 * u * u / kRisingSteps,
                     line);
        }
    }
    void add_falling(double to, SightLine& line) const {
        for (int k = 0; k < kFallingSteps; ++k)
            add_step(to * (k + 0.5) / kFallingSteps, to / kFallingSteps, line);
    }
};

AirParts log_of(AirParts m) {
    return {std::log(m.air + kLeastMass), std::log(m.haze + kLeastMass),
            std::log(m.ozone + kLeastMass)};
}

}  // namespace

SightLine sight_line(double eye_m, double sin_elevation) {
    const double radius = kSkyRadius_m + eye_m, along = radius * sin_elevation;
    const double lowest2 = radius * radius - along * along;
    const Walker walker{radius, along, std::sqrt(std::max(lowest2, 0.0)) / radius};
    const double top = kSkyRadius_m + kSkyTop_m;
    const double end = std::sqrt(top * top - lowest2) - along;
    SightLine line;
    if (along >= 0.0) {
        walker.add_rising(0.0, end, line);
    } else if (lowest2 < kSkyRadius_m * kSkyRadius_m) {
        line.to_ground = true;
        walker.add_falling(-along - std::sqrt(kSkyRadius_m * kSkyRadius_m - lowest2), line);
    } else {
        walker.add_falling(-along, line);
        walker.add_rising(-along, end, line);
    }
    return line;
}

double dip_of_horizon(double eye_m) {
    return std::acos(kSkyRadius_m / (kSkyRadius_m + std::max(eye_m, 0.0)));
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
