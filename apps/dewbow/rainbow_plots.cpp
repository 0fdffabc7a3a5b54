// SPDX-License-Identifier: Apache-2.0
#include "rainbow_plots.h"

#include <algorithm>

#include "dewbow/base/check.h"
#include "rainbow_output.h"

namespace dewbow {

const std::vector<RainbowPlotRow>& rainbow_plots() {
    static const std::vector<RainbowPlotRow> rows{
        {"intensity", "what drops send into each direction, logarithmic", {".svg"}, draw_intensity},
        {"intensity-linear", "the same, linear", {".svg"}, draw_intensity_linear},
        {"polarisation", "degree of polarisation by angle", {".svg"}, draw_polarisation},
        {"rays", "rays through the drop, and their deflection", {".svg"}, draw_rays},
        {"strip", "colours by angle", {".svg", ".png"}, draw_strip},
        {"paper", "the rainbows of Musgrave 1989 as strips", {".svg", ".png"}, draw_paper},
        {"errata", "what is wrong in them, measured", {".svg", ".csv"}, draw_errata},
        {"arc", "the bow in the sky, by the sun's altitude", {".svg", ".png"}, draw_arc},
        {"lee",
         "colours by angle and drop size, each size as bright as it can be",
         {".svg", ".png"},
         draw_lee},
    };
    return rows;
}

std::string rainbow_plot(const std::string& kind, const std::string& file, RainbowTables& tables) {
    const auto& rows = rainbow_plots();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const RainbowPlotRow& r) { return r.kind == kind; });
    DEWBOW_CHECK(row != rows.end(), "the command line knows the kinds of plots");
    return row->draw(tables, ending_of(file));
}

}  // namespace dewbow
