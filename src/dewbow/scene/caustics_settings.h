// SPDX-License-Identifier: Apache-2.0
#pragma once

// How `--estimator caustics` spends its light paths.

#include <string>

namespace dewbow {

/// Most light paths for each sample of a pixel.
inline constexpr double kMostLightPaths = 1000.0;

struct CausticsSettings {
    /// Light paths for each sample of each pixel of the whole picture; 0 = camera paths alone.
    double light_paths = 1.0;
    /// Light paths start where earlier ones have arrived; else evenly towards what is specular.
    bool aimed = true;
};

/// All settings in one line: equal if and only if they are.
std::string text_of(const CausticsSettings& settings);

}  // namespace dewbow
