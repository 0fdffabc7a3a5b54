// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sky_light.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/parallel.h"

namespace dewbow {
namespace {

/// Light of an irradiance of 1 that air and haze scatter once towards the eye, at kSkyWavelengths.
void single_scattering(const std::vector<SightStep>& line, double elevation, double azimuth,
                       const SunPlace& sun, const SunMasses& masses, const SkyOptics& optics,
                       double asymmetry, double* out) {
    const double cosine =
        std::sin(elevation) * sun.sine + std::cos(elevation) * sun.cosine * std::cos(azimuth);
    const double p_air = air_phase(cosine), p_haze = haze_phase(cosine, asymmetry);
    std::fill_n(out, kSkyWavelengths, 0.0);
    for (const SightStep& step : line) {
        const double r = kSkyRadius_m + step.height_m;
        const double sin_sun = (kSkyRadius_m * sun.sine + step.distance_m * cosine) / r;
        const double visible = visible_share_of_sun(step.height_m, sin_sun);
        if (visible <= 0.0) continue;
        const AirParts mass = step.mass + masses.at(step.height_m, sin_sun);
        for (int k = 0; k < kSkyWavelengths; ++k) {
            const double scattered = optics[k].depth.air * p_air * step.step_mass.air +
                                     optics[k].haze_scattering * p_haze * step.step_mass.haze;
            out[k] += visible * scattered * std::exp(-dot(optics[k].depth, mass));
        }
    }
}

}  // namespace

SkyOptics sky_optics(const ClearSky& sky) {
    SkyOptics optics;
    for (int k = 0; k < kSkyWavelengths; ++k)
        optics[k] = air_optics(sky, sky_wavelength_nm(k) * unit::nm);
    return optics;
}

std::vector<double> sky_light(const ClearSky& sky, const SunPlace& sun) {
    const SkyOptics optics = sky_optics(sky);
    const SunMasses masses(sun.altitude);
    std::vector<double> values(std::size_t{kSkyElevations} * kSkyAzimuths * kSkyWavelengths);
    parallel_for(kSkyElevations, [&](std::size_t i) {
        const double elevation = sky_elevation(static_cast<int>(i));
        const std::vector<SightStep> line = sight_line(std::sin(elevation));
        for (int j = 0; j < kSkyAzimuths; ++j)
            single_scattering(line, elevation, sky_azimuth(j), sun, masses, optics,
                              sky.aerosol_asymmetry,
                              &values[(i * kSkyAzimuths + j) * kSkyWavelengths]);
    });
    return values;
}

}  // namespace dewbow
