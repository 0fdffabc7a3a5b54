// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sky_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/parallel.h"

namespace dewbow {
namespace {

/// Of the sun's altitude, to both sides, between which the diffuse field is taken as linear.
constexpr double kSlopeStep = 1.0 * std::numbers::pi / 180.0;

std::vector<Harmonics> slope_of(const std::vector<Harmonics>& lower,
                                const std::vector<Harmonics>& higher, double step) {
    std::vector<Harmonics> slope = higher;
    for (std::size_t level = 0; level < slope.size(); ++level)
        for (std::size_t n = 0; n < kDiffuseHarmonics; ++n)
            slope[level][n] = (higher[level][n] - lower[level][n]) / step;
    return slope;
}

/// Light of an irradiance of 1 that air and haze scatter once towards the eye, added to `out` by
/// wavelength.
void add_single_scattering(const SightLine& line, double eye_m, double elevation, double azimuth,
                           const ClearDay& day, double* out) {
    const double cosine = std::sin(elevation) * day.sun.sine +
                          std::cos(elevation) * day.sun.cosine * std::cos(azimuth);
    const double p_air = air_phase(cosine), p_haze = haze_phase(cosine, day.asymmetry);
    for (const SightStep& step : line.steps) {
        const double r = kSkyRadius_m + step.height_m;
        const double sin_sun =
            ((kSkyRadius_m + eye_m) * day.sun.sine + step.distance_m * cosine) / r;
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

/// Light that has been scattered before and is once more, along one elevation: its azimuthal modes
/// as if all places had the eye's sun, and what comes on top, times cos φ, since they have not.
struct Modes {
    std::array<double, kDiffuseDegree + 1> even{}, tilted{};

    double at(double azimuth) const {
        const double towards = std::cos(azimuth);
        double sum = 0.0;
        for (int m = 0; m <= kDiffuseDegree; ++m)
            sum += (even[m] + towards * tilted[m]) * std::cos(m * azimuth);
        return std::max(sum, 0.0);
    }
};

/// What a step of a line of sight scatters on to the eye, by degree l.
PhaseMoments scattered_share(const SightStep& step, const AirOptics& optics,
                             const PhaseMoments& air, const PhaseMoments& haze) {
    const double left = std::exp(-dot(optics.depth, step.mass));
    const double by_air = left * optics.depth.air * step.step_mass.air;
    const double by_haze = left * optics.haze_scattering * step.step_mass.haze;
    PhaseMoments share;
    for (int l = 0; l <= kDiffuseDegree; ++l) share[l] = by_air * air[l] + by_haze * haze[l];
    return share;
}

Modes multiple_scattering(const std::vector<SightStep>& line,
                          const std::vector<Harmonics>& harmonics, const ClearDay& day, int k) {
    const PhaseMoments air = air_phase_moments(), haze = haze_phase_moments(day.asymmetry);
    Modes modes;
    for (std::size_t s = 0; s < line.size(); ++s) {
        const PhaseMoments share = scattered_share(line[s], day.optics[k], air, haze);
        const Harmonics here = day.diffuse[k].at(line[s].height_m);
        const Harmonics slope = day.diffuse_slope[k].at(line[s].height_m);
        const double higher = line[s].level_angle;
        std::size_t n = 0;
        for (int m = 0; m <= kDiffuseDegree; ++m)
            for (int l = m; l <= kDiffuseDegree; ++l, ++n) {
                modes.even[m] += share[l] * harmonics[s][n] * here[n];
                modes.tilted[m] += share[l] * harmonics[s][n] * slope[n] * higher;
            }
    }
    return modes;
}

/// One elevation, all azimuths: [azimuth][wavelength].
void light_row(const ClearDay& day, double eye_m, double elevation, double* out) {
    const SightLine line = sight_line(eye_m, std::sin(elevation));
    std::vector<Harmonics> harmonics(line.steps.size());
    for (std::size_t s = 0; s < line.steps.size(); ++s)
        legendre_harmonics(kDiffuseDegree, line.steps[s].sin_altitude, harmonics[s]);
    for (int k = 0; k < kSkyWavelengths; ++k) {
        const Modes modes = multiple_scattering(line.steps, harmonics, day, k);
        const double ground =
            line.to_ground ? day.ground[k] * std::exp(-dot(day.optics[k].depth, line.mass)) : 0.0;
        for (int j = 0; j < kSkyAzimuths; ++j)
            out[j * kSkyWavelengths + k] = ground + modes.at(sky_azimuth(j));
    }
    for (int j = 0; j < kSkyAzimuths; ++j)
        add_single_scattering(line, eye_m, elevation, sky_azimuth(j), day,
                              out + j * kSkyWavelengths);
}

}  // namespace

ClearDay::ClearDay(const ClearSky& sky, const SunPlace& where)
    : asymmetry(sky.aerosol_asymmetry),
      sun(where),
      masses(where.altitude),
      diffuse(kSkyWavelengths),
      diffuse_slope(kSkyWavelengths) {
    parallel_for(kSkyWavelengths, [&](std::size_t at) { solve(sky, static_cast<int>(at)); });
}

void ClearDay::solve(const ClearSky& sky, int k) {
    optics[k] = air_optics(sky, sky_wavelength_nm(k) * unit::nm);
    const auto ground_of = [&](const SunPlace& place) {
        return visible_share_of_sun(0.0, place.sine) * std::max(place.sine, 0.0) *
               std::exp(-dot(optics[k].depth, masses.at(0.0, place.sine)));
    };
    const SunPlace lower(sun.altitude - kSlopeStep), higher(sun.altitude + kSlopeStep);
    const auto beam_of = [&](const SunPlace& place) {
        return beam_moments(optics[k], place, masses);
    };
    const auto field_of = [&](const SunPlace& place, const std::vector<Harmonics>& slope = {}) {
        return diffuse_field(optics[k], asymmetry, sky.ground_albedo, beam_of(place),
                             ground_of(place), slope);
    };
    diffuse_slope[k].moments =
        slope_of(field_of(lower).moments, field_of(higher).moments, 2.0 * kSlopeStep);
    std::vector<Harmonics> slope = slope_of(beam_of(lower), beam_of(higher), 2.0 * kSlopeStep);
    for (std::size_t level = 0; level < slope.size(); ++level)
        for (std::size_t n = 0; n < kDiffuseHarmonics; ++n)
            slope[level][n] += diffuse_slope[k].moments[level][n];
    diffuse[k] = field_of(sun, slope);
    ground[k] =
        sky.ground_albedo / std::numbers::pi * (ground_of(sun) + diffuse[k].ground_irradiance);
}

double azimuth_from(Dir<World> to_sun, Dir<World> direction) {
    const double along = direction.v.x * to_sun.v.x + direction.v.z * to_sun.v.z;
    const double across = direction.v.x * to_sun.v.z - direction.v.z * to_sun.v.x;
    return std::atan2(std::abs(across), along);
}

double reach_of(SkyHalf half, double eye_m) {
    const double dip = dip_of_horizon(eye_m);
    return 0.5 * std::numbers::pi + (half == SkyHalf::above ? dip : -dip);
}

std::vector<double> sky_light(const ClearDay& day, SkyHalf half, double eye_m) {
    const double dip = dip_of_horizon(eye_m), reach = reach_of(half, eye_m);
    std::vector<double> values(std::size_t{kSkyElevations} * kSkyAzimuths * kSkyWavelengths);
    parallel_for(kSkyElevations, [&](std::size_t i) {
        // A hair off the horizon, so that the line ends where it should.
        const double angle = std::max(sky_angle(static_cast<int>(i), reach), 1e-9);
        const double elevation = half == SkyHalf::above ? angle - dip : -angle - dip;
        light_row(day, eye_m, elevation, &values[i * kSkyAzimuths * kSkyWavelengths]);
    });
    return values;
}

}  // namespace dewbow
