// SPDX-License-Identifier: Apache-2.0
#pragma once

// What tables of phase functions can be asked for.

#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Throws InputError unless there is one at least, they ascend, and are 100 nm to 20 µm.
void check_wavelengths(const std::vector<Wavelength>& wavelengths);
/// Throws InputError unless there is one at least, they ascend, and are 0° to 180°.
void check_scattering_angles(const std::vector<Angle>& angles);

}  // namespace dewbow
