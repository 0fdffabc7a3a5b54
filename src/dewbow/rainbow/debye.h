// SPDX-License-Identifier: Apache-2.0
#pragma once

// Model `debye`: Mie's exact answer taken apart into orders of light.

#include <memory>

#include "dewbow/rainbow/models.h"

namespace dewbow {

/// Spheres of real index n >= 1, x from 1e-3 to 20,000; an AmplitudeModel. It gives the coherent
/// sum of `options.orders`, any p >= 0, where p = 0 has diffraction with the reflection outside
/// (debye_series.h). No orders: the sum of all by its closed form, which is Mie's answer. An
/// order's share of the extinction is that of the optical theorem and adds up over orders; the
/// other efficiencies are those of the sum as it stands, without interference with what is left
/// out.
///
/// Throws InputError for an order below 0; one named twice counts once.
std::unique_ptr<ScatteringModel> make_debye(const ModelOptions& options);

}  // namespace dewbow
