// SPDX-License-Identifier: Apache-2.0
#pragma once

// The glasses, gems and fluids that are known by name. A glass is a row of
// data/glasses/catalogue.csv.

#include <span>
#include <string>
#include <string_view>

#include "dewbow/optics/dispersion.h"

namespace dewbow {

struct Glass {
    std::string name;  ///< "schott/N-BK7", "gem/diamond", "fluid/water"
    std::string description;
    DispersionData data;
    double n_d = 0.0;  ///< as published, against `data.reference`; 0 = not published
    double v_d = 0.0;  ///< as published; 0 = not published
    double lambda_min_nm = 0.0, lambda_max_nm = 0.0;  ///< range of the data
    std::string source;                               ///< citation
};

/// The catalogue, in the order of its file.
std::span<const Glass> glass_catalogue();

/// The glass of that name. The maker may be left out where the rest is unique, and case and hyphens
/// do not matter ("N-BK7", "diamond", "nbk7"). Throws InputError: unknown with the nearest names,
/// or ambiguous with all of them.
const Glass& find_glass(std::string_view name);

}  // namespace dewbow
