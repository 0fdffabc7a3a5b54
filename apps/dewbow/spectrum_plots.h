// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plots of `dewbow spectrum`: a new one is a row here and a file spectrum_plot_*.cpp.

#include <string>
#include <vector>

#include "spectrum_setup.h"

namespace dewbow {

struct SpectrumPlotRow {
    std::string kind;
    std::string summary;               ///< for help, in a few words
    std::vector<std::string> endings;  ///< of its files: ".svg"
    bool shows_colours;                ///< as they look: --gamma is of these
    /// The bytes of a file of that ending.
    std::string (*draw)(const SpectrumSetup& setup, const std::string& ending);
};
const std::vector<SpectrumPlotRow>& spectrum_plots();

bool shows_colours(const PlotRequest& plot);
/// The bytes of `file`, a plot of this kind.
std::string spectrum_plot(const PlotRequest& plot, const SpectrumSetup& setup);

// One file each.
std::string draw_spectrum_curves(const SpectrumSetup& setup, const std::string& ending);
std::string draw_spectrum_sums(const SpectrumSetup& setup, const std::string& ending);
std::string draw_spectrum_strip(const SpectrumSetup& setup, const std::string& ending);
std::string draw_spectrum_white(const SpectrumSetup& setup, const std::string& ending);

/// Colours in which red, green and blue are drawn.
inline constexpr const char* kChannelColours[3] = {"#c8281e", "#1e8c3c", "#2350c8"};
inline constexpr const char* kChannelNames[3] = {"red", "green", "blue"};

}  // namespace dewbow
