// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drops for tests.

#include "dewbow/optics/catalogue.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow {

/// Of water at 20 °C in air; quick to make with the model "descartes".
inline DropCloudRequest test_drops(double extinction_per_m, const char* sizes = "0.5mm",
                                   const char* model = "descartes") {
    DropCloudRequest request;
    request.model = model;
    request.showers = {parse_drop_sizes(sizes)};
    request.optics = {make_dispersion(find_glass("water@20C").data),
                      make_dispersion(find_glass("air").data), 0.0};
    request.amount = RainExtinction{extinction_per_m};
    return request;
}

}  // namespace dewbow
