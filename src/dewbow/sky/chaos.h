// SPDX-License-Identifier: Apache-2.0
#pragma once

// A solid texture: a number at each point of space, irregular at all sizes alike. The paper's
// "Chaos()" ("a stochastic scalar quantity with a 1/f² power spectrum"), by which its rainbows and
// our rain are brighter here and fainter there.
//                [Musgrave 1989, 4.3.2; Perlin, "An Image Synthesizer", Computer Graphics 19(3),
//                1985]

#include <cstdint>

#include "dewbow/math/vector.h"

namespace dewbow {

/// Octaves of gradient noise, each finer than the last by the factor `lacunarity`.
struct Chaos {
    int octaves = 8;  ///< 1 to kMostChaosOctaves
    /// Of the coarsest octave, in cells of noise per unit of the point, > 0: per metre where points
    /// are places, per radian (for neighbouring directions) where they are directions.
    double base_frequency = 1.0;
    double lacunarity = 2.0;  ///< 1.1 to 10
    /// β of the power spectrum f^−β on straight cuts, 1 to 4, from the base frequency to that of
    /// the finest octave. An octave's amplitude is lacunarity^−(β−1)/2 of the last one's: the
    /// paper's 1/f² is 2, Perlin's amplitudes 1/f are 3.
    double exponent = 2.0;
    /// Sheets: what lies along `axis` (a unit vector, upright or slanted) is `stretch` times as
    /// long, > 0.
    Vec3 axis{0.0, 1.0, 0.0};
    double stretch = 1.0;
    std::uint64_t seed = 0;  ///< another one is another texture
    /// From the texture to a density: clamp(bias + gain · chaos, 0, 1).
    double bias = 0.0, gain = 1.0;
};
inline constexpr int kMostChaosOctaves = 24;

/// 0 to 1, with the mean 1/2 and the standard deviation 1/6: what lies further out than three of
/// them, 0.3 % of a sum of many octaves, is cut off. Continuous, with its first two derivatives but
/// for the cut. A function of its arguments alone. So far away that doubles have no place between
/// the points of the lattice, and where `p` is not finite, it is 1/2.
/// Cost: about 50 ns an octave.
double chaos(Vec3 p, const Chaos& texture);

/// clamp(bias + gain · chaos, 0, 1): the share of a density, or of a fog, that is there.
double chaos_density(Vec3 p, const Chaos& texture);

}  // namespace dewbow
