// SPDX-License-Identifier: Apache-2.0
#pragma once

// A white source on black, seen through a prism near minimum deviation: each colour is the source
// again, turned aside in proportion to its spectral coordinate f. What is seen is the source's
// profile convolved with the spectrum, in closed form for the linear colours of Musgrave 1989.

#include "aliasing/eye.h"

namespace dewbow::bench {

/// Angles along the dispersion, in arc minutes.
struct Sight {
    double spread = 0.0;  ///< from f = 0, red at 800 nm, to f = 1, violet at 380 nm; > 0
    double source = 0.0;  ///< width of the source, with sharp edges
    double pixel = 0.0;   ///< width of the picture's pixels; their blur counts as a Gaussian's
};

/// As an eye sees it at `angle` from the middle of the source's reddest picture, with infinitely
/// many samples.
Colour<Opponent> seen_in_the_limit(const Sight& sight, double angle);
/// With `samples` fixed ones, whose colours are divided by their sum.
Colour<Opponent> seen_with_samples(const Sight& sight, int samples, double angle);

/// The largest visible difference between both, anywhere. What jitter and correlation do to the
/// mean of a picture is nothing: it is that of the limit.
double aliasing(const Sight& sight, int samples);

/// The largest root mean square of visible noise anywhere in a picture whose pixels hold the mean
/// of `sets` sets of samples that are jittered, each alone or all by a common offset.
double noise(const Sight& sight, int samples, bool correlated, int sets);
/// The same in the middle of a white field as wide as the sky.
double noise_of_white(int samples, bool correlated, int sets, double pixel_arcmin);

}  // namespace dewbow::bench
