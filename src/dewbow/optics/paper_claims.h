// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the paper says of glasses, measured on the catalogue.

#include <cstddef>
#include <string_view>

namespace dewbow {

/// "Dispersive power is independent of optical density" [Musgrave 1989, §3.2]: Pearson's
/// correlation of w (eq. 2) with n_D.
struct PowerAndDensity {
    std::size_t glasses = 0;
    double correlation = 0.0;
};
/// Over the catalogue's media with dispersion, but gases, whose names begin with `maker`
/// ("schott/"; all: "").
PowerAndDensity power_and_density(std::string_view maker);

}  // namespace dewbow
