// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sky_light.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dewbow/base/parallel.h"

namespace dewbow {
namespace {

/// Light of an irradiance of 1 that air and haze scatter once towards the eye, added to `out` by
/// wavelength.
void add_single_scattering(const std::vector<SightStep>& line, double elevation, double azimuth,
                           const ClearDay& day, double* out) {
    const double cosine = std::sin(elevation) * day.sun.sine +
                          std::cos(elevation) * day.sun.cosine * std::cos(azimuth);
    const double p_air = air_phase(cosine), p_haze = haze_phase(cosine, day.asymmetry);
    for (const SightStep& step : line) {
        const double r = kSkyRadius_m + step.height_m;
        const double sin_sun = (kSkyRadius_m * day.sun.sine + step.distance_m * cosine) / r;
        const double visible = visible_share_of_sun(step.height_m, sin_sun);
        if (visible <= 0.0) continue;
        const AirParts mass = step.mass + day.masses.at(step.height_m, sin_sun);
        for (int k = 0; k < kSkyWavelengths; ++k) {
            const AirOptics& o = day.optics[k];
            const double scattered = o.depth.air * p_air * step.step_mass.air +
                                     o.haze_scattering * p_haze * step.step_mass.haze;
            out[k] += visible * scattered * std::exp(-dot(o.depth, mass));
        }
    }
}

/// Light that has been scattered before and is once more, along one elevation: its azimuthal modes.
using Modes = std::array<double, kDiffuseDegree + 1>;

Modes multiple_scattering(const std::vector<SightStep>& line,
                          const std::vector<Harmonics>& harmonics, const ClearDay& day, int k) {
    const AirOptics& o = day.optics[k];
    const PhaseMoments air = air_phase_moments(), haze = haze_phase_moments(day.asymmetry);
    Modes modes{};
    for (std::size_t s = 0; s < line.size(); ++s) {
        const SightStep& step = line[s];
        const double left = std::exp(-dot(o.depth, step.mass));
        const double by_air = left * o.depth.air * step.step_mass.air;
        const double by_haze = left * o.haze_scattering * step.step_mass.haze;
        const Harmonics moments = day.diffuse[k].moments_at(step.height_m);
        std::size_t n = 0;
        for (int m = 0; m <= kDiffuseDegree; ++m)
            for (int l = m; l <= kDiffuseDegree; ++l, ++n)
                modes[m] += (by_air * air[l] + by_haze * haze[l]) * moments[n] * harmonics[s][n];
    }
    return modes;
}

double at_azimuth(const Modes& modes, double azimuth) {
    double sum = 0.0;
    for (int m = 0; m <= kDiffuseDegree; ++m) sum += modes[m] * std::cos(m * azimuth);
    return std::max(sum, 0.0);
}

/// One elevation, all azimuths: [azimuth][wavelength].
void light_row(const ClearDay& day, double elevation, double* out) {
    const std::vector<SightStep> line = sight_line(std::sin(elevation));
    std::vector<Harmonics> harmonics(line.size());
    for (std::size_t s = 0; s < line.size(); ++s)
        legendre_harmonics(kDiffuseDegree, line[s].sin_altitude, harmonics[s]);
    for (int k = 0; k < kSkyWavelengths; ++k) {
        const Modes modes = multiple_scattering(line, harmonics, day, k);
        for (int j = 0; j < kSkyAzimuths; ++j)
            out[j * kSkyWavelengths + k] = at_azimuth(modes, sky_azimuth(j));
    }
    for (int j = 0; j < kSkyAzimuths; ++j)
        add_single_scattering(line, elevation, sky_azimuth(j), day, out + j * kSkyWavelengths);
}

}  // namespace

ClearDay::ClearDay(const ClearSky& sky, const SunPlace& where)
    : asymmetry(sky.aerosol_asymmetry), sun(where), masses(where.altitude) {
    for (int k = 0; k < kSkyWavelengths; ++k)
        optics[k] = air_optics(sky, sky_wavelength_nm(k) * unit::nm);
    std::array<std::optional<DiffuseLight>, kSkyWavelengths> solved;
    parallel_for(kSkyWavelengths, [&](std::size_t k) {
        solved[k].emplace(optics[k], asymmetry, sky.ground_albedo, sun, masses);
    });
    for (auto& one : solved) diffuse.push_back(std::move(*one));
}

std::vector<double> sky_light(const ClearDay& day) {
    std::vector<double> values(std::size_t{kSkyElevations} * kSkyAzimuths * kSkyWavelengths);
    parallel_for(kSkyElevations, [&](std::size_t i) {
        light_row(day, sky_elevation(static_cast<int>(i)),
                  &values[i * kSkyAzimuths * kSkyWavelengths]);
    });
    return values;
}

}  // namespace dewbow
