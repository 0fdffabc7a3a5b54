// SPDX-License-Identifier: Apache-2.0

// What the paper's rainbow gets wrong: a panel for each erratum.

#include <algorithm>
#include <cmath>

#include "dewbow/export/plot.h"
#include "dewbow/rainbow/paper/errata.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr std::size_t kColumns = 3;

/// From the least to the greatest of what is finite.
PlotAxis axis_of(const std::string& label, const std::vector<ErratumCurve>& curves,
                 std::vector<double> ErratumCurve::*values) {
    double low = INFINITY, high = -INFINITY;
    for (const ErratumCurve& curve : curves)
        for (double v : curve.*values)
            if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    PlotAxis axis;
    axis.label = label;
    axis.from = low, axis.to = high;
    return axis;
}

/// With a margin at both ends.
PlotAxis upright_axis(const Erratum& erratum) {
    PlotAxis axis = axis_of(erratum.y_label, erratum.curves, &ErratumCurve::y);
    axis.logarithmic = erratum.logarithmic;
    if (axis.logarithmic) {
        constexpr double kFactor = 1.5;
        axis.from /= kFactor, axis.to *= kFactor;
    } else {
        const double margin = (axis.to - axis.from) / 15.0;
        axis.from -= margin, axis.to += margin;
    }
    return axis;
}

PlotPanel panel_of(const Erratum& erratum) {
    PlotPanel panel;
    panel.title = erratum.name + ": " + erratum.subject;
    panel.x = axis_of(erratum.x_label, erratum.curves, &ErratumCurve::x);
    panel.y = upright_axis(erratum);
    for (std::size_t k = 0; k < erratum.curves.size(); ++k) {
        const ErratumCurve& from = erratum.curves[k];
        PlotCurve curve;
        curve.label = from.label, curve.colour = plot_colour(k), curve.dashed = from.as_published;
        for (std::size_t i = 0; i < from.x.size(); ++i)
            curve.points.push_back({from.x[i], from.y[i]});
        panel.curves.push_back(curve);
    }
    return panel;
}

}  // namespace

std::string draw_errata(RainbowTables&, const std::string& ending) {
    const std::vector<Erratum> errata = paper_errata();
    if (ending == ".csv") return csv_of(errata);
    std::vector<PlotPanel> panels;
    for (const Erratum& erratum : errata) panels.push_back(panel_of(erratum));
    return svg_of(panels, kColumns);
}

}  // namespace dewbow
