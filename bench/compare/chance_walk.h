// SPDX-License-Identifier: Apache-2.0
#pragma once

// One wavelength walks through a scene of caustics, from a lamp or from the eye: the steps that
// both have in common.

#include <cstdint>
#include <vector>

#include "dewbow/base/random.h"
#include "emission.h"
#include "things.h"

namespace dewbow::bench {

/// Independent numbers of one walk.
class Chances {
public:
    Chances(std::uint64_t seed, std::uint64_t walk) : key_(hash_combine(seed, walk)) {}
    double next() { return double(hash_combine(key_, ++count_) >> 11) * 0x1p-53; }

private:
    std::uint64_t key_, count_ = 0;
};

/// All that depends on one wavelength.
struct WalkBand {
    std::vector<double> index;    ///< of bodies, against vacuum
    double around = 1.0;          ///< of what surrounds them
    std::vector<double> sources;  ///< spectra of the emission's sources
    Colour<LinearSrgb> film_weight;
    double index_of(int medium) const { return medium < 0 ? around : index[std::size_t(medium)]; }
};
/// One for each of film_wavelengths().
std::vector<WalkBand> walk_bands(const PlainScene& scene);

/// The spectrum of a source, counted as in EmittedRay.
const Spectrum& spectrum_of(const PlainScene& scene, int source);
int sources_of(const PlainScene& scene);

/// At a body: chooses between reflection and refraction, and changes direction and medium.
/// @param normal  against d.
void cross_boundary(const Things& things, const Meeting& met, Vec3 normal, const WalkBand& band,
                    Chances& chances, Vec3& d, Inside& inside);

/// At a receiver: a direction by Lambert's law about the normal.
Vec3 scattered(Vec3 normal, Chances& chances);

/// A walk that is still caught in a body after so many meetings is given up: less than 1e-6 of the
/// light in a brilliant, all of whose rays leave within some hundred.
inline constexpr int kMostMeetings = 1000;

}  // namespace dewbow::bench
