// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {

/// Drops of several tables together, of each as many as make the same geometric cross section:
/// their efficiencies on average, their phase functions weighted by what they scatter. The tables
/// have the same angles and wavelengths; at least one.
ScatteringTable mixed_evenly(std::span<const ScatteringTable> tables);

}  // namespace dewbow
