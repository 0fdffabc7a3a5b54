// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's spectral coordinate. [Musgrave 1989, 4.1: "frequency is specified in the range
// [0..1]"]

#include <string>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// What the coordinate is linear in; the paper has both words.
enum class SpectralSpacing { frequency, wavelength };
/// Their words, in this order.
const std::vector<std::string>& spectral_spacing_names();

/// f runs from 0 at `red` to 1 at `violet`:
/// f = (1/λ − 1/red) / (1/violet − 1/red), or (red − λ) / (red − violet).
struct SpectralCoordinate {
    Wavelength red, violet;
    SpectralSpacing spacing = SpectralSpacing::frequency;

    /// At f; any f above that of infinite wavelength, which is below 0.
    Wavelength wavelength(double f) const;
    /// f at `lambda` > 0; below 0 or above 1 outside the range.
    double at(Wavelength lambda) const;
    /// |dλ/df| in nm.
    double nm_per_f(double f) const;
};

}  // namespace dewbow
