// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which spreads the prisms of the world have.

#include <optional>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow::bench {

struct Prism {
    std::string name;
    double w = 0.0;                     ///< dispersive power
    double eta_red = 0.0, slope = 0.0;  ///< η(f) = eta_red + slope f, against air
    double spread_arcmin = 0.0;
};

/// Spread of light that passes at minimum deviation for f = 1/2; nothing where a colour is
/// reflected totally.
std::optional<double> spread_arcmin(double eta_red, double slope, Angle apex);

/// Prisms of `apex` from water to four times SF11's dispersive power: of real glasses by their
/// indices at 800 and 380 nm, or by the paper's line through 800 nm, of a slope that its 0.76 makes
/// half of the real one. Those that no prism of this apex lets through are left out.
std::vector<Prism> real_prisms(Angle apex);
std::vector<Prism> paper_prisms(Angle apex);

}  // namespace dewbow::bench
