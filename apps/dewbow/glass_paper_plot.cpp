// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/export/plot.h"
#include "glass_paper.h"

namespace dewbow {
namespace {

constexpr double kStep_nm = 2.0;
/// Off by less than the best of glass makers' catalogues.
constexpr double kLeastError = 1e-7;

template <class Index>
PlotCurve curve_of(const std::string& label, std::size_t colour, bool dashed, const Index& n) {
    PlotCurve curve{label, plot_colour(colour), {}, dashed};
    for (double nm = kPaperSpectrum.from_nm; nm <= kPaperSpectrum.to_nm; nm += kStep_nm)
        curve.points.push_back({nm, n(nm)});
    return curve;
}

PlotAxis wavelength_axis() {
    return {"wavelength in air λ (nm)", kPaperSpectrum.from_nm, kPaperSpectrum.to_nm};
}

/// As printed the index is far below what the others are, and not shown.
PlotPanel index_panel(const GlassPaper& paper) {
    PlotPanel panel;
    panel.title = paper.title;
    panel.x = wavelength_axis();
    panel.y.label = "index against air";
    const auto f = [&](double nm) {
        return paper_coordinate(vacuum_wavelength(nm), paper.spacing);
    };
    if (paper.real) panel.curves.push_back(curve_of("real", 0, false, paper.real));
    for (const PaperReading& reading : paper.readings) {
        if (!reading.line || reading.reading == IndexReading::printed) continue;
        const std::size_t colour = reading.reading == IndexReading::intended ? 1 : 2;
        panel.curves.push_back(curve_of(reading.name(), colour, true,
                                        [&](double nm) { return reading.line->at(f(nm)); }));
    }
    double low = INFINITY, high = -INFINITY;
    for (const PlotCurve& curve : panel.curves)
        for (const PlotPoint& p : curve.points)
            low = std::min(low, p.y), high = std::max(high, p.y);
    const double margin = std::max((high - low) / 15.0, 1e-5);
    panel.y.from = low - margin, panel.y.to = high + margin;
    return panel;
}

PlotPanel error_panel(const GlassPaper& paper) {
    PlotPanel panel;
    panel.title = "Formulas fitted over 405–670 nm; dashed: as printed";
    panel.x = wavelength_axis();
    panel.y = {"|Δn|", kLeastError, 1.0, true};
    std::size_t colour = 0;
    std::string last;
    for (const PaperFit& fit : paper.fits) {
        if (!last.empty() && last != fit.formula->name) ++colour;
        last = fit.formula->name;
        panel.curves.push_back(curve_of(
            fmt::format("{} ({})", fit.formula->name, fit.formula->constants), colour,
            !fit.formula->right, [&](double nm) {
                return std::max(std::abs(fit.narrow.index(nm) - paper.real(nm)), kLeastError);
            }));
    }
    return panel;
}

}  // namespace

std::string glass_paper_plot(const GlassPaper& paper) {
    std::vector<PlotPanel> panels{index_panel(paper)};
    if (paper.real) panels.push_back(error_panel(paper));
    return svg_of(panels);
}

}  // namespace dewbow
