// SPDX-License-Identifier: Apache-2.0
#pragma once

// The colours of a bow: from phase functions by wavelength to XYZ by angle, and to a screen.

#include <vector>

#include "dewbow/rainbow/scattering_table.h"
#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// The light that drops scatter, by angle. Y = 1 is what drops with P = 1, Q_sca = 1 send under the
/// white light.
struct BowColours {
    std::vector<Angle> angles;                         ///< scattering angles, ascending
    std::vector<Colour<Xyz>> perpendicular, parallel;  ///< each as bright as if all light were so

    Colour<Xyz> unpolarised(std::size_t i) const { return 0.5 * (perpendicular[i] + parallel[i]); }
};

/// ∫ Q_sca(λ) P(λ) light(λ) (x̄, ȳ, z̄)(λ) dλ over ∫ white(λ) ȳ(λ) dλ, both over the table's
/// wavelengths, with Q P linear between them; a table of one wavelength is a line there. What the
/// model does not know counts as 0. Throws InputError where nothing of the wavelengths is visible.
BowColours bow_colours(const ScatteringTable& table, const Spectrum& light, const Spectrum& white);

/// Linear between the angles, and the end values beyond them.
Colour<Xyz> colour_at(const std::vector<Angle>& angles, const std::vector<Colour<Xyz>>& colours,
                      Angle angle);

/// Settings under which `white` looks white, and the brightest channel of `shown` is just as bright
/// as the screen's white.
DisplaySettings settings_for(const std::vector<Colour<Xyz>>& shown, const Spectrum& white);

}  // namespace dewbow
