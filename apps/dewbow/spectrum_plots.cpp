// SPDX-License-Identifier: Apache-2.0
#include "spectrum_plots.h"

#include <algorithm>

#include "dewbow/base/check.h"
#include "rainbow_output.h"

namespace dewbow {
namespace {

const SpectrumPlotRow& row_of(const PlotRequest& plot) {
    const auto& rows = spectrum_plots();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const SpectrumPlotRow& r) { return r.kind == plot.kind; });
    DEWBOW_CHECK(row != rows.end(), "the command line knows the kinds of plots");
    return *row;
}

}  // namespace

const std::vector<SpectrumPlotRow>& spectrum_plots() {
    static const std::vector<SpectrumPlotRow> rows{
        {"curves",
         "red, green and blue over the spectrum, with the samples",
         {".svg"},
         true,
         draw_spectrum_curves},
        {"sums",
         "red + green + blue; of empirical colours with and without negative values",
         {".svg"},
         true,
         draw_spectrum_sums},
        {"strip", "what the spectrum looks like", {".svg", ".png"}, true, draw_spectrum_strip},
        {"white",
         "what sets of samples make of white: by common offset, as a histogram, or of fixed "
         "samples by their number",
         {".svg", ".csv"},
         false,
         draw_spectrum_white},
    };
    return rows;
}

bool shows_colours(const PlotRequest& plot) { return row_of(plot).shows_colours; }

std::string spectrum_plot(const PlotRequest& plot, const SpectrumSetup& setup) {
    return row_of(plot).draw(setup, ending_of(plot.file));
}

}  // namespace dewbow
