// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/spectrum/cie.h"

namespace dewbow {

/// Y of `spectrum`, 1 for the constant 1: what lights are compared by.
inline double brightness(const Spectrum& spectrum) {
    return xyz_from_spectrum(spectrum)[1] / cie_y_integral();
}

}  // namespace dewbow
