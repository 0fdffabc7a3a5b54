// SPDX-License-Identifier: Apache-2.0
#pragma once

// The metals that are known by name, with their measured complex index n + ik. A metal is a row of
// data/metals/metals.csv.

#include <complex>
#include <span>
#include <string>
#include <string_view>

#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

struct Metal {
    std::string name;    ///< "metal/gold"
    std::string symbol;  ///< "Au"; empty for a second measurement of a metal
    std::string description;
    std::string source;                               ///< citation
    std::string licence;                              ///< of its numbers
    double lambda_min_nm = 0.0, lambda_max_nm = 0.0;  ///< range of the data
    /// Against vacuum; piecewise linear between the measurements, held outside their range.
    SpectrumPtr n, k;

    std::complex<double> index(Wavelength lambda) const { return {(*n)(lambda), (*k)(lambda)}; }
};

/// The catalogue, in the order of its file.
std::span<const Metal> metal_catalogue();

/// The metal of that name or symbol ("metal/gold", "gold", "Au"), as find_named understands names.
/// Throws InputError: unknown, with the nearest names.
const Metal& find_metal(std::string_view name);

}  // namespace dewbow
