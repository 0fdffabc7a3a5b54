// SPDX-License-Identifier: Apache-2.0
#pragma once

// Camera paths and light paths together: `path`, and beside it paths that start at the lamps,
// aimed at what bends or mirrors light. Shares: weights.h.

#include <memory>
#include <string>

#include "dewbow/render/estimator.h"

namespace dewbow {

/// `scene` must outlive the estimator. Where no lamp shines on a caster it is `path`, bit by bit.
std::unique_ptr<Estimator> make_caustics_estimator(const Scene& scene);
std::string caustics_settings(const RenderSettings& settings);

}  // namespace dewbow
