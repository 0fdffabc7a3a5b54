// SPDX-License-Identifier: Apache-2.0
#pragma once

// The empirical spectrum of Musgrave 1989, 4.2.2: "xyz coordinates of monochromatic colors weighted
// by […] the CIE standard illuminant B", on a monitor, "piecewise linear between samples taken at
// 10nm […] intervals from 380 to 770 nm".

#include <array>

#include "dewbow/base/quantity.h"
#include "dewbow/spectrum/rgb.h"
#include "dewbow/spectrum/spectral_model.h"

namespace dewbow {

inline constexpr Wavelength kEmpiricalRed = 770.0 * unit::nm, kEmpiricalViolet = 380.0 * unit::nm;
inline constexpr Wavelength kEmpiricalStep = 10.0 * unit::nm;
inline constexpr int kEmpiricalNodes = 40;

/// Curves per nm. What a matrix of the monitor makes of x̄ȳz̄ × B is scaled so that B is (1, 1, 1),
/// then negative channels are treated, then each channel is brought back to an area of 1.
struct EmpiricalCurves {
    std::array<MonitorRgb, kEmpiricalNodes> per_nm;  ///< at 380, 390 … 770 nm
    std::array<double, 3> area;  ///< of each channel before the last step: 1 unless clamped

    /// Linear between the nodes, 0 outside.
    MonitorRgb at(Wavelength lambda) const;
};
/// The chromaticities of `monitor` with the white of illuminant B.
EmpiricalCurves empirical_curves(const RgbPrimaries& monitor, NegativeColours negative);

}  // namespace dewbow
