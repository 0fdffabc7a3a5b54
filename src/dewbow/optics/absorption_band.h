// SPDX-License-Identifier: Apache-2.0
#pragma once

// The index of refraction near an absorption band: what the paper's Fig. 3.1 shows.

#include <complex>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// One band of a medium, as a damped oscillator.                                  [Lorentz 1880]
struct AbsorptionBand {
    double b = 1.0;                   ///< strength, Sellmeier's b
    Wavelength c = 100.0 * unit::nm;  ///< of the band, Sellmeier's c
    double damping = 0.0;  ///< γ, the band's width as a share of its frequency; 0: Sellmeier's
};

/// n + ik with (n + ik)² = 1 + b / (1 − x² − i γ x), x = c/λ.      [Born & Wolf 1999, §2.3.4]
/// With γ = 0 it is Sellmeier's n² = 1 + b λ²/(λ² − c²): infinite at c, imaginary between
/// c/√(1 + b) and c.
std::complex<double> index_near(const AbsorptionBand& band, Wavelength lambda);

}  // namespace dewbow
