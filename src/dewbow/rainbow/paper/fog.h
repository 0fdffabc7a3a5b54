// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fog that the paper's rainbows are made of.                         [Musgrave 1989, eq. 14]

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Share of the colour behind that fog replaces with its own: r = 1 − e^{−hd/t}, 0 at distance 0
/// and 1 infinitely far away. A transmittance t that is infinite means no fog at any distance.
/// @param h  the constant, > 0.  @param d  distance, >= 0.  @param t  transmittance, > 0.
double fog_replacement(InverseLength h, Length d, double t);
/// As printed, r = e^{hd/t}: 1 at distance 0, then ever more.
double fog_replacement_as_printed(InverseLength h, Length d, double t);

}  // namespace dewbow
