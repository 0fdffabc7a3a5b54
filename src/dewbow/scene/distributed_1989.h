// SPDX-License-Identifier: Apache-2.0
#pragma once

// How `--estimator distributed_1989` makes pictures. The defaults are what the paper published.

#include <string>
#include <vector>

#include "dewbow/spectrum/spectral_samples.h"

namespace dewbow {

/// What becomes of the N samples of a split when they are added up.
enum class SampleSum {
    clamp,  ///< at white, as the paper does
    wrap,   ///< in 8 bits a channel, as it failed in 1989: beyond white comes black
    free,   ///< no limit
};
/// What a ray brings home.
enum class RgbOrSpectral {
    rgb,       ///< three numbers; a sample multiplies them by its own three
    spectral,  ///< radiance by wavelength; a sample takes its own wavelength of it
};
/// Which index a medium has.
enum class IndexSource {
    linear,  ///< the paper's straight line with the medium's index at 800 nm and dispersive power
    scene,   ///< that of the scene
};
enum class ReflectanceAt {
    nominal,   ///< Fresnel's factor by the index at sodium's D line, for all rays
    spectral,  ///< by the index at each wavelength
};
// The words for these, each in the order of its enumerators.
const std::vector<std::string>& sample_sum_names();
const std::vector<std::string>& rgb_or_spectral_names();
const std::vector<std::string>& index_source_names();
const std::vector<std::string>& reflectance_at_names();

struct Distributed1989Settings {
    SpectralModelSettings model;
    SpectralSampling sampling;
    SampleSum sum = SampleSum::clamp;
    RgbOrSpectral transport = RgbOrSpectral::rgb;
    IndexSource index = IndexSource::linear;
    ReflectanceAt reflectance = ReflectanceAt::nominal;
    /// Branches of the tree of rays that would add less than this share are not followed; 0 = all
    /// are. One step of 8 bits.      [Hall & Greenberg 1983, "adaptive tree depth control"]
    double least_weight = 1.0 / 255.0;
};

/// All settings in one line: equal if and only if they are.
std::string text_of(const Distributed1989Settings& settings);

}  // namespace dewbow
