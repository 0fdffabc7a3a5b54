// SPDX-License-Identifier: Apache-2.0
#pragma once

// The wavelengths at which true pictures are summed.

#include <vector>

#include "plain_scene.h"

namespace dewbow::bench {

struct FilmWavelength {
    double lambda_nm = 0.0;
    double pdf_per_nm = 0.0;  ///< of a wavelength drawn from the list, each entry as often
    /// Linear sRGB of a radiance of 1 W m⁻² sr⁻¹ nm⁻¹, divided by the density.
    Colour<LinearSrgb> film_weight;
};

/// 4096 of them, rising, in proportion to x̄ + ȳ + z̄ and a little everywhere: neighbours are 0.1 nm
/// apart in the green, which moves no edge of the scenes by a thousandth of a pixel.
/// @param film_from_xyz  as in PlainScene.
std::vector<FilmWavelength> film_wavelengths(double film_from_xyz);

/// The weight of any wavelength.
Colour<LinearSrgb> film_weight(double lambda_nm, double pdf_per_nm, double film_from_xyz);

}  // namespace dewbow::bench
