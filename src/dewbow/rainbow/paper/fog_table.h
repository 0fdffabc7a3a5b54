// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's second rainbow: rays through a drop, gathered by angle into a table of fogs.
// Everything that is wrong in it can be put right, one thing at a time.
//                                                                      [Musgrave 1989, 4.3.2]

#include <cstdint>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/sun_disc.h"
#include "dewbow/spectrum/linear_model.h"

namespace dewbow {

/// Buckets over 180° from the antisolar point.
inline constexpr int kPaperBuckets = 1800;
inline constexpr Angle kPaperBucket = 0.1 * unit::deg;

/// Where the index of water comes from.
enum class PaperWater {
    cauchy,  ///< 1.3239 + 3116.3 nm² / λ², fitted to an index relative to air
    iapws,   ///< IAPWS R9-97 at 20 °C, divided by that of air
};

/// What smears the bow of a point into the sun's.
enum class SunKernel {
    none,
    five_entries,  ///< a semicircle of radius 0.25° at the middles of five buckets
    disc,          ///< a disc of 0.2666° integrated over buckets: seven entries
};

/// The method as published; docs/rainbow-errata.md says what each field costs.
struct PaperMethod {
    RayDensity density = RayDensity::even_in_impact_parameter;
    bool per_solid_angle = false;  ///< each bucket divided by its solid angle
    PaperWater water = PaperWater::cauchy;
    bool divide_by_air = true;  ///< by 1.0003, although the index is relative to air already
    SunKernel kernel = SunKernel::five_entries;
    int wavelengths = kPaperSamples;
    SpectralSpacing spacing = SpectralSpacing::frequency;
    bool jitter_wavelengths = false;  ///< a new wavelength, and colour, for each ray
    int rays = 50'000;                ///< for each wavelength; 0: the limit of ever more
    bool random_rays = false;         ///< at random, instead of evenly
    std::uint64_t seed = 0;
};
PaperMethod paper_method_corrected();

/// As Snell's law wants it.
RelativeIndex paper_index(const PaperMethod& method, Wavelength lambda);

/// Kernel over neighbouring buckets, from −k to k, of sum 1.
std::vector<double> sun_kernel(SunKernel kernel);

/// `values` smeared by a kernel of odd length; ends mirrored, so that the sum stays.
std::vector<double> convolve_mirrored(const std::vector<double>& values,
                                      const std::vector<double>& kernel);

/// Flux of rays reflected once and twice in the drop, by angle from the antisolar point, of a point
/// sun: parts of the flux that meets the drop, or those per steradian. [bucket]
/// Throws InputError for a negative number of rays.
std::vector<double> paper_intensities(const PaperMethod& method, Wavelength lambda);

/// By angle from the antisolar point. [bucket]
struct FogTable {
    std::vector<Colour<LinearSrgb>> intensity;      ///< over the greatest of all, 0 to 1
    std::vector<Colour<LinearSrgb>> transmittance;  ///< its inverse, infinite where empty
};
/// Intensities times colours, smeared by the sun, normalised and inverted, in this order.
/// Throws InputError unless there is a wavelength, and rays to jitter if they are to be.
FogTable make_fog_table(const PaperMethod& method);

}  // namespace dewbow
