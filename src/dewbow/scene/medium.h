// SPDX-License-Identifier: Apache-2.0
#pragma once

// What fills a body that light goes into.

#include <memory>
#include <string>

#include "dewbow/optics/dispersion.h"
#include "dewbow/optics/phase_function.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

struct Medium {
    std::string name;
    DispersionPtr index;
    /// Absorption coefficient by wavelength, in m⁻¹; nullptr = clear.
    SpectrumPtr absorption;
    /// Where bodies overlap, the one of higher priority fills the overlap. [Schmidt & Budge 2002]
    int priority = 0;
    /// Scattering coefficient by wavelength, in m⁻¹; nullptr = clear. Haze has both or neither.
    SpectrumPtr scattering = nullptr;
    PhaseFunctionPtr phase = nullptr;
};
using MediumPtr = std::shared_ptr<const Medium>;

}  // namespace dewbow
