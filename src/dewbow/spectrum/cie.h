// SPDX-License-Identifier: Apache-2.0
#pragma once

// The CIE 1931 2° standard observer.

#include <array>
#include <span>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectrum.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// x̄, ȳ, z̄ at `lambda_nm`: linear between the 1 nm values of the CIE, zero outside 360–830 nm.
/// [CIE 018:2019 table, DOI 10.25039/CIE.DS.xvudnb9b]
std::array<double, 3> cie_xyz_bar(double lambda_nm);

/// Luminous efficacy at the peak, lm W⁻¹.
inline constexpr double kLuminousEfficacy = 683.002;

/// (∫ S x̄ dλ, ∫ S ȳ dλ, ∫ S z̄ dλ) over 360–830 nm, by the trapezoid rule at 0.5 nm: for a spectral
/// radiance in W m⁻² sr⁻¹ nm⁻¹, Y × 683.002 is its luminance in cd m⁻².
Colour<Xyz> xyz_from_spectrum(const Spectrum& spectrum);

/// One packet's estimate of the same integral: (1/N) Σ_k L_k (x̄, ȳ, z̄)(λ_k) / pdf_k.
Colour<Xyz> xyz_from_lanes(const WavelengthPacket& packet, std::span<const double> values);

/// ∫ ȳ dλ: the Y of the spectrum that is 1 everywhere (106.857).
double cie_y_integral();

}  // namespace dewbow
