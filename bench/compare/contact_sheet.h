// SPDX-License-Identifier: Apache-2.0
#pragma once

// All pictures on one sheet.

#include "dewbow/image/image.h"
#include "measurement.h"

namespace dewbow::bench {

/// For each scene the true picture and a picture of each result, as a screen shows them (clipped to
/// sRGB), with their settings, CPU time and root mean square error below.
Image8 contact_sheet(const Measurements& all);

}  // namespace dewbow::bench
