// SPDX-License-Identifier: Apache-2.0
#pragma once

// The spectral lines that glass makers state indices at. Makers give the wavelengths in air; ours
// are those in vacuum, as everywhere.

#include <optional>
#include <span>
#include <string_view>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// Wavelengths in air of the lines of the Abbe number, as makers state them, in nm.
inline constexpr double kAirF_nm = 486.1327, kAird_nm = 587.5618, kAirC_nm = 656.2725;
/// The same lines in vacuum: times the index of air at 20 °C. The sodium doublet's middle, D, is
/// what the paper's dispersive power is about.
inline constexpr Wavelength kLineF = 486.26617913 * unit::nm;
inline constexpr Wavelength kLined = 587.72187001 * unit::nm;
inline constexpr Wavelength kLineC = 656.45069408 * unit::nm;
inline constexpr Wavelength kLineD = 589.45432598 * unit::nm;

struct FraunhoferLine {
    std::string_view name;    ///< "d", "F'"
    std::string_view origin;  ///< the element
    double air_nm = 0.0;
};
/// From violet to infrared.                              [SCHOTT TIE-29, table 1; G and B: Fe, O2]
std::span<const FraunhoferLine> fraunhofer_lines();

/// The line of that name, whose case matters (d is helium, D sodium), or nothing.
std::optional<FraunhoferLine> fraunhofer_line(std::string_view name);

/// The vacuum wavelength of light that has `air_nm` in air of 20 °C, 101325 Pa. Error: 1e-9 nm.
Wavelength vacuum_wavelength(double air_nm);

}  // namespace dewbow
