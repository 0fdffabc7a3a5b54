// SPDX-License-Identifier: Apache-2.0
#pragma once

// The errata one by one.

#include "dewbow/rainbow/paper/errata.h"

namespace dewbow::errata {

Erratum ring_index();         ///< E11
Erratum cauchy_fit();         ///< E12
Erratum air_counted_twice();  ///< E13
Erratum geometry();           ///< E14
Erratum ray_weights();        ///< E15
Erratum kernel_of_the_sun();  ///< E16
Erratum thirteen_samples();   ///< E17
Erratum beyond_the_fit();     ///< E22
Erratum fog_and_order();      ///< E23

}  // namespace dewbow::errata
