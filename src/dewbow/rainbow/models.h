// SPDX-License-Identifier: Apache-2.0
#pragma once

// The models by name.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// What becomes of a model's answer afterwards: `auto` may leave away what that washes out.
struct Averaging {
    double relative_width = 0.0;  ///< standard deviation of the drops' radii over their mean
    Angle disc_radius{};          ///< of the sun; 0 for a point
};

struct ModelOptions {
    Orders orders;  ///< of light in the drop that count; empty: all that the model has
    Averaging averaging;
    double tolerance = 0.02;  ///< of `auto`: of the primary bow's peak
};

struct ScatteringModelRow {
    std::string name;
    std::string summary;  ///< one line: what it holds and where
    /// Throws InputError for orders that the model does not have.
    std::unique_ptr<ScatteringModel> (*make)(const ModelOptions& options);
};
/// From the simplest to the exact one, and `auto`.
const std::vector<ScatteringModelRow>& scattering_models();

/// Throws InputError: unknown name, with the nearest.
std::unique_ptr<ScatteringModel> make_scattering_model(std::string_view name,
                                                       const ModelOptions& options = {});

}  // namespace dewbow
