// SPDX-License-Identifier: Apache-2.0
#pragma once

// The dispersion of 1989: distributed ray tracing in which a ray is split into N coloured ones at
// its first refraction.                                         [Musgrave 1989, 4.1 and 4.2]

#include <memory>

#include "dewbow/render/estimator.h"

namespace dewbow {

/// `scene` must outlive the estimator. Throws InputError if the film has spectral bins, if it
/// rains in the scene, or if the samples of the spectrum leave a channel without light.
std::unique_ptr<Estimator> make_distributed_1989_estimator(const Scene& scene);
std::string distributed_1989_settings(const RenderSettings& settings);

}  // namespace dewbow
