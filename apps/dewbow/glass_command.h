// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow glass` is asked for, as plain values. A glass is named by the catalogue, or by a
// file: "schott/N-BK7", "maker.agf#N-BK7", "page.yml".

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dewbow/spectrum/spectral_coordinate.h"

namespace dewbow {

struct GlassListCommand {
    std::string filter;  ///< part of a name, alias or description; empty: all
    bool json = false;
};

/// `show` with one name, `compare` with several.
struct GlassShowCommand {
    std::vector<std::string> names;
    std::vector<double> at_nm;  ///< vacuum wavelengths
    std::string plot;           ///< an SVG file, or empty
    bool json = false;
};

struct GlassImportCommand {
    std::string file;
    std::string name;  ///< of one glass, whose scene snippet is printed; empty: list all
    std::string rows;  ///< a CSV file to write, or empty
    bool json = false;
};

/// From a glass, or from n_d with one number of a unit of dispersion_units().
struct GlassConvertCommand {
    std::string name;
    double n_d = 0.0;
    std::string unit;
    double value = 0.0;
    bool json = false;
};

/// The paper's index of a glass, or of η at the far red and w; of neither: of the whole catalogue.
struct GlassPaperCommand {
    std::string name;
    double eta_red = 0.0, w = 0.0;
    SpectralSpacing spacing = SpectralSpacing::frequency;
    std::string plot;  ///< an SVG file, or empty
    bool json = false;

    bool is_of_all() const { return name.empty() && eta_red == 0.0; }
};

using GlassCommand = std::variant<GlassListCommand, GlassShowCommand, GlassImportCommand,
                                  GlassConvertCommand, GlassPaperCommand>;

// Each returns the program's exit code.
int run(const GlassListCommand& command);
int run(const GlassShowCommand& command);
int run(const GlassImportCommand& command);
int run(const GlassConvertCommand& command);
int run(const GlassPaperCommand& command);

}  // namespace dewbow
