// SPDX-License-Identifier: Apache-2.0
#pragma once

// A smooth function of wavelength and of a direction above the horizon, or below it, that is
// symmetric about the sun's meridian.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace dewbow {

/// Where a clear sky is computed: knots of the angle from the horizon, `reach` (i / (n − 1))²,
/// where reach is the angle between the horizon and straight up (or down), and of azimuth from the
/// sun, even from 0 to 180°.
inline constexpr int kSkyElevations = 40;
inline constexpr int kSkyAzimuths = 46;
/// Wavelengths at which it is computed, even over the visible range.
inline constexpr int kSkyWavelengths = 24;

double sky_angle(int i, double reach);  ///< from the horizon, in the unit of reach
double sky_azimuth(int j);              ///< radians
double sky_wavelength_nm(int k);

class SkyTable {
public:
    /// @param values  [elevation][azimuth][wavelength], positive or 0.
    explicit SkyTable(std::span<const double> values);

    /// Into `out`, at a direction by its angle from the horizon as a share of its reach, 0 to 1,
    /// and its azimuth from the sun, 0 to π. Cubic in both (Catmull & Rom), and cubic in the
    /// logarithm over wavelength, sampled every 5 nm and linear between. Never negative.
    void eval_lanes(double share, double azimuth, std::span<const double> lambda_nm,
                    std::span<double> out) const;
    /// The weighted sum over wavelength: weights for eval() that belong to kFineWavelengths knots.
    std::vector<double> weighted_sum(std::span<const double> fine_weights) const;

    static constexpr int kFineWavelengths = 95;
    static constexpr double kFineStep_nm = 5.0;

private:
    std::vector<float> values_;  ///< [elevation][azimuth][fine wavelength]
};

/// Cubic interpolation on the grid of directions: the 16 knots around a place.
struct SkyStencil {
    SkyStencil(double share, double azimuth);
    std::array<std::size_t, 16> knots;  ///< elevation · kSkyAzimuths + azimuth
    std::array<double, 16> weights;     ///< sum 1
};

/// Values at kSkyWavelengths to values every 5 nm: cubic in their logarithms.
std::vector<double> refine_over_wavelength(std::span<const double> values);

}  // namespace dewbow
