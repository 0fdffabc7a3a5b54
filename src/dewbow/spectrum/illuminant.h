// SPDX-License-Identifier: Apache-2.0
#pragma once

// Standard illuminants and the black body.

#include <string>
#include <string_view>
#include <vector>

#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// "D65", "A", "B", "C" or "E", scaled so that Y = cie_y_integral() — a relative spectrum as bright
/// as the constant 1; or nullptr for a name that is none of illuminant_names().
SpectrumPtr find_illuminant(std::string_view name);
std::vector<std::string> illuminant_names();

/// Planck's spectral radiance of a black body in vacuum.  [CODATA 2018 constants]
SpectralRadiance planck_radiance(Temperature temperature, Wavelength lambda);
/// The black body at `temperature` scaled as find_illuminant scales. Range 500 to 1e6 K, else
/// InputError.
SpectrumPtr make_blackbody(Temperature temperature);

}  // namespace dewbow
