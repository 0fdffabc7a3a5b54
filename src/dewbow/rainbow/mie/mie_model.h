// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model `mie`: exact for spheres of any index.

#include <memory>

#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// An AmplitudeModel. All of the light together: throws InputError if orders are asked for, and
/// its objects throw for drops that are no spheres and as mie_waves does.
std::unique_ptr<ScatteringModel> make_mie(const ModelOptions& options);

}  // namespace dewbow
