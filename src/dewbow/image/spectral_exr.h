// SPDX-License-Identifier: Apache-2.0
#pragma once

// The layout of spectra in OpenEXR. [Fichet, Pacanowski & Wilkie, "An OpenEXR Layout for Spectral
// Images", JCGT 10(3) 2021]

#include <optional>
#include <string>
#include <string_view>

#include "dewbow/base/quantity.h"
#include "dewbow/image/image.h"

namespace dewbow {

/// "S0.550,000000nm": unpolarised (Stokes 0) emission at `centre`.
std::string emissive_channel_name(Wavelength centre);
/// The wavelength that an emissive S0 channel name states, or nothing. Any unit and number form
/// that the layout allows is read ("S0.5,5e2nm", "S0.0,55um", "S0.545,077196THz": c / frequency).
std::optional<Wavelength> emissive_channel_wavelength(std::string_view name);
/// spectralLayoutVersion, emissiveUnits and EV, which the layout asks for. The units are the
/// layout's only ones: they do not say whether a channel holds its band's sum or a density. Ours
/// hold W m⁻² sr⁻¹ nm⁻¹.
Attributes spectral_attributes();

}  // namespace dewbow
