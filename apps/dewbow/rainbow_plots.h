// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plots of `dewbow rainbow`: a new one is a row here and a file rainbow_plot_*.cpp.

#include <string>
#include <vector>

#include "rainbow_tables.h"

namespace dewbow {

struct RainbowPlotRow {
    std::string kind;
    std::string summary;               ///< for help, in a few words
    std::vector<std::string> endings;  ///< of its files: ".svg"
    /// The bytes of a file of that ending. Throws InputError.
    std::string (*draw)(RainbowTables& tables, const std::string& ending);
};
const std::vector<RainbowPlotRow>& rainbow_plots();

/// The bytes of `file`, a plot of this kind. Throws InputError.
std::string rainbow_plot(const std::string& kind, const std::string& file, RainbowTables& tables);

// One file each.
std::string draw_intensity(RainbowTables& tables, const std::string& ending);
std::string draw_intensity_linear(RainbowTables& tables, const std::string& ending);
std::string draw_polarisation(RainbowTables& tables, const std::string& ending);
std::string draw_rays(RainbowTables& tables, const std::string& ending);
std::string draw_strip(RainbowTables& tables, const std::string& ending);
std::string draw_paper(RainbowTables& tables, const std::string& ending);
std::string draw_errata(RainbowTables& tables, const std::string& ending);
std::string draw_arc(RainbowTables& tables, const std::string& ending);
std::string draw_lee(RainbowTables& tables, const std::string& ending);

}  // namespace dewbow
