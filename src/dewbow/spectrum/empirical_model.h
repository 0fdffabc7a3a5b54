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

/// What (1, 1, 1) is before negative channels are treated.
enum class EmpiricalWhite {
    illuminant,  ///< B
    monitor,     ///< the monitor's own, with the luminance of B: what the paper's graphs may show
};

/// Curves per nm: what the monitor's matrix makes of x̄ȳz̄ × B; negative channels are treated, and
/// then each channel is brought to an area of 1.
struct EmpiricalCurves {
    std::array<MonitorRgb, kEmpiricalNodes> per_nm;  ///< at 380, 390 … 770 nm
    std::array<double, 3> area;                      ///< of each channel before the last step

    /// Linear between the nodes, 0 outside.
    MonitorRgb at(Wavelength lambda) const;
};
EmpiricalCurves empirical_curves(const RgbPrimaries& monitor, NegativeColours negative,
                                 EmpiricalWhite white = EmpiricalWhite::illuminant);

}  // namespace dewbow
