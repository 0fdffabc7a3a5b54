// SPDX-License-Identifier: Apache-2.0
#pragma once

// `dewbow glass paper`: the paper's index beside the true one.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dewbow/optics/paper_formulas.h"
#include "dewbow/optics/paper_index.h"
#include "glass_command.h"

namespace dewbow {

/// One reading of eq. 9.
struct PaperReading {
    IndexReading reading;
    std::optional<LinearIndex> line = std::nullopt;  ///< nothing beyond the pole
    double w = 0.0;                                  ///< that the line has, by eq. 2
    std::optional<double> worst = std::nullopt;      ///< greatest |Δn| from the true glass

    const std::string& name() const { return index_reading_names()[std::size_t(reading)]; }
};

/// A line of the spectrum, or an end of it.
struct PaperLine {
    const char* name;
    double lambda_nm = 0.0, f = 0.0;
    std::optional<double> real = std::nullopt;
};

/// A formula fitted over the whole of the paper's spectrum, and over the range of its water.
struct PaperFit {
    const PaperFormula* formula;
    FittedFormula whole, narrow;
    IndexError whole_error, narrow_error;
    IndexError beyond;  ///< of the narrow fit over the whole spectrum
};

struct GlassPaper {
    std::string title;
    double eta_red = 1.0, w = 0.0;
    SpectralSpacing spacing = SpectralSpacing::frequency;
    IndexInAir real;  ///< empty where η and w were given
    std::array<PaperReading, 3> readings;
    std::array<PaperLine, 5> lines;
    std::vector<PaperFit> fits;
    std::vector<std::string> notes;
};

/// Throws UsageError: a wrong name, a medium without dispersion.
GlassPaper glass_paper(const GlassPaperCommand& command);
/// The index over the wavelength, and how far each formula is off, as one SVG.
std::string glass_paper_plot(const GlassPaper& paper);
/// Of no glass: w against n_D of the whole catalogue, and Fig. 3.1, an absorption band.
std::string glass_claims_plot();

}  // namespace dewbow
