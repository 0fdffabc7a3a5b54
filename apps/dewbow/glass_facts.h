// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the subcommands of `dewbow glass` say about a glass.

#include <string>
#include <vector>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"

namespace dewbow {

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

/// The glass of a name or a file. A wrong name throws UsageError, a wrong file InputError.
Glass glass_named(const std::string& name);

struct GlassFacts {
    Glass glass;
    DispersionPtr dispersion;
    IndexInAir in_air;                                 ///< against air, of wavelengths in air
    double n_d = 0.0, V_d = 0.0, w = 0.0, P_gF = 0.0;  ///< V_d is infinite without dispersion

    explicit GlassFacts(Glass of);
    /// Against what the glass's data are against, at a vacuum wavelength.
    double index(double lambda_nm) const;
    double index_in_vacuum(double lambda_nm) const;
    bool has_data_at(double lambda_nm) const;
    /// What has to be said about it.
    std::vector<std::string> notes() const;
};

}  // namespace dewbow
