// SPDX-License-Identifier: Apache-2.0
#pragma once

// From the chromaticities of primaries to the matrix of an RGB space.

#include "dewbow/spectrum/matrix3.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {

/// XYZ with Y = 1.
constexpr Triple xyz_from_chromaticity(std::array<double, 2> xy) {
    return {xy[0] / xy[1], 1.0, (1.0 - xy[0] - xy[1]) / xy[1]};
}

/// The matrix that takes (1, 0, 0) … to multiples of the primaries and (1, 1, 1) to `white`, in
/// XYZ. [SMPTE RP 177]
constexpr Matrix3 matrix_of_primaries(const RgbPrimaries& primaries, const Triple& white) {
    const Matrix3 columns = matrix_of_columns(xyz_from_chromaticity(primaries.red),
                                              xyz_from_chromaticity(primaries.green),
                                              xyz_from_chromaticity(primaries.blue));
    const Triple strength = inverse(columns) * white;
    return columns * diagonal(strength);
}

/// The same for the primaries' own white with Y = 1.
constexpr Matrix3 matrix_of_primaries(const RgbPrimaries& primaries) {
    return matrix_of_primaries(primaries, xyz_from_chromaticity(primaries.white));
}

}  // namespace dewbow
