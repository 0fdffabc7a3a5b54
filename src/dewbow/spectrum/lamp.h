// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lights that are known by name: illuminants of the CIE, measured lamps and LEDs, spectral
// lines of gases and lasers. A lamp is a row of data/lamps/lamps.csv.

#include <span>
#include <string>
#include <string_view>

#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

struct Lamp {
    std::string name;  ///< "led/cool-white", "laser/hene", "illuminant/D65"
    std::string kind;  ///< "illuminant", "incandescent", "fluorescent", "discharge", "led", "laser"
    std::string description;
    std::string source;   ///< citation
    std::string licence;  ///< of its numbers
    /// Relative power, scaled so that Y = cie_y_integral(): as bright as the constant 1.
    SpectrumPtr spectrum;
};

/// The catalogue, in the order of its file.
std::span<const Lamp> lamp_catalogue();

/// The lamp of that name, as find_named understands names ("led/cool-white", "hene", "D65"). Throws
/// InputError: unknown with the nearest names, or ambiguous with all of them.
const Lamp& find_lamp(std::string_view name);

}  // namespace dewbow
