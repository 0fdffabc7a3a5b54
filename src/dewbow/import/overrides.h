// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the command line changes in a scene, whatever file it comes from.

#include "dewbow/import/import.h"

namespace dewbow {

/// Makes the materials of those names bodies of those glasses. What was glass before keeps its
/// roughness, tint, absorption and priority; what was something else becomes smooth and clear, and
/// is there as a whole. Throws UsageError with the nearest names.
void override_glasses(Scene& scene, const std::vector<GlassOverride>& overrides,
                      Diagnostics& diagnostics);

/// Puts the picture `file` in the place of all environments. Its (1, 1, 1) is the film's white.
/// Throws UsageError where it cannot be read.
void override_environment(Scene& scene, const std::string& file, Diagnostics& diagnostics);

/// `scale` with which an environment's (1, 1, 1) is the film's white.
double environment_scale_of_white(const Film& film);

}  // namespace dewbow
