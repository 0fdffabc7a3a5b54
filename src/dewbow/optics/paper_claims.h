// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the paper says of glasses, measured on the catalogue.

#include <cstddef>
#include <string_view>
#include <vector>

namespace dewbow {

/// Against air, at the paper's lines: n_D and the dispersive power w (eq. 2).
struct IndexAndPower {
    double n_D = 1.0, w = 0.0;
};
/// Of the catalogue's media with dispersion, but gases, whose names begin with `maker` ("schott/";
/// all: "").
std::vector<IndexAndPower> indices_and_powers(std::string_view maker);

/// "Dispersive power is independent of optical density" [Musgrave 1989, §3.2]: Pearson's
/// correlation of w (eq. 2) with n_D.
struct PowerAndDensity {
    std::size_t glasses = 0;
    double correlation = 0.0;
};
/// Over the same media.
PowerAndDensity power_and_density(std::string_view maker);

}  // namespace dewbow
