// SPDX-License-Identifier: Apache-2.0
#pragma once

// Standard illuminants and the black body.

#include <string>
#include <string_view>
#include <vector>

#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// An illuminant of the CIE ("D65", "A", "E", "FL2", "HP1", "LED-B3"…), scaled so that
/// Y = cie_y_integral() — a relative spectrum as bright as the constant 1; or nullptr for a name
/// that is none of illuminant_names(). lamp.h has them with their sources.
SpectrumPtr find_illuminant(std::string_view name);
std::vector<std::string> illuminant_names();

/// Planck's spectral radiance of a black body in vacuum.  [CODATA 2018 constants]
SpectralRadiance planck_radiance(Temperature temperature, Wavelength lambda);
/// The black body at `temperature` scaled as find_illuminant scales. Range 500 to 1e6 K, else
/// InputError.
SpectrumPtr make_blackbody(Temperature temperature);

}  // namespace dewbow
