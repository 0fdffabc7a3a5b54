// SPDX-License-Identifier: Apache-2.0
#pragma once

// What sets of samples make of white.

#include <array>
#include <vector>

#include "spectrum_setup.h"

namespace dewbow {

/// The sums of a channel over sets.
struct WhiteChannel {
    double mean = 0.0, sd = 0.0, least = 0.0, greatest = 0.0;
    double above_one = 0.0;  ///< share of the sets
    double clamped = 0.0;    ///< mean of the sums, each clamped to 1
};

struct SpectrumWhite {
    std::vector<MonitorRgb> sums;  ///< one a set; of correlated jitter by rising offset
    std::array<WhiteChannel, 3> channels;
    double any_above_one = 0.0;
};

/// Colours that move: `sets` of the command, at even common offsets or at random ones. Else one
/// set.
SpectrumWhite measure_white(const SpectrumSetup& setup);

}  // namespace dewbow
