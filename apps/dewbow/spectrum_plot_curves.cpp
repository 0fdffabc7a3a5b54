// SPDX-License-Identifier: Apache-2.0

// Figs. 4.1 and 4.2: red, green and blue over the spectrum; Fig. 4.3: their sum.

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "dewbow/spectrum/empirical_model.h"
#include "dewbow/spectrum/monitors.h"
#include "spectrum_plots.h"

namespace dewbow {
namespace {

constexpr int kSteps = 1300;  ///< hits the nodes of the linear curves
constexpr double kHeadroom = 1.06;
/// More lines than these would hide the curves.
constexpr int kMostSampleLines = 60;

std::string code(const std::array<std::uint8_t, 3>& rgb) {
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

void add_band(const SpectrumSetup& setup, PlotPanel& panel) {
    constexpr int kStops = 130;
    for (const double f : setup.steps(kStops))
        panel.band.push_back({setup.place(f), code(setup.shown(f))});
}

void fit_height(PlotPanel& panel) {
    double least = 0.0, most = 0.0;
    for (const PlotCurve& curve : panel.curves)
        for (const PlotPoint& p : curve.points) {
            least = std::min(least, p.y);
            most = std::max(most, p.y);
        }
    panel.y.from = least < 0.0 ? kHeadroom * least - 0.05 * most : 0.0;
    panel.y.to = kHeadroom * most;
}

PlotCurve zero_line(const PlotPanel& panel) {
    return {"", "#888888", {{panel.x.from, 0.0}, {panel.x.to, 0.0}}, false, 1.0};
}

/// The paper's vertical lines: where the samples lie.
void add_sample_lines(const SpectrumSetup& setup, PlotPanel& panel) {
    const int samples = setup.command().sampling.samples;
    if (samples > kMostSampleLines) return;
    for (int k = 0; k < samples; ++k) {
        const double x = setup.place(setup.prepared().sample(k, 0.5).f_colour);
        panel.curves.insert(
            panel.curves.begin(),
            {"", "#bbbbbb", {{x, panel.y.from}, {x, panel.y.to}}, /*dashed=*/true, 1.0});
    }
}

const char* unit_of(const SpectrumSetup& setup) {
    return setup.over_wavelength() ? "share of white per nm" : "number for the monitor";
}

PlotPanel panel_of(const SpectrumSetup& setup, const std::string& title) {
    PlotPanel panel;
    panel.title = title;
    panel.x = setup.axis();
    panel.y.label = unit_of(setup);
    add_band(setup, panel);
    return panel;
}

/// r + g + b of the empirical model before channels are brought to unit area, as in Fig. 4.3.
PlotPanel empirical_sums(const SpectrumSetup& setup, EmpiricalWhite white,
                         const std::string& title) {
    PlotPanel panel = panel_of(setup, title);
    const char* labels[] = {"with negative values", "clamped to zero", "limited to the gamut"};
    const auto& monitor = find_monitor(setup.command().model.monitor).primaries;
    for (const std::size_t i : {0u, 1u, 2u}) {
        const auto curves = empirical_curves(monitor, static_cast<NegativeColours>(i), white);
        PlotCurve curve{labels[i], plot_colour(i), {}, /*dashed=*/i == 2};
        for (const double f : setup.steps(kSteps)) {
            const MonitorRgb rgb = curves.at(setup.model().wavelength(f));
            curve.points.push_back({setup.place(f), dot(rgb.v, curves.area)});
        }
        panel.curves.push_back(std::move(curve));
    }
    panel.curves.push_back(zero_line(panel));
    fit_height(panel);
    return panel;
}

}  // namespace

std::string draw_spectrum_curves(const SpectrumSetup& setup, const std::string&) {
    PlotPanel panel = panel_of(setup, setup.title());
    for (std::size_t c = 0; c < 3; ++c) {
        PlotCurve curve{kChannelNames[c], kChannelColours[c], {}};
        for (const double f : setup.steps(kSteps))
            curve.points.push_back({setup.place(f), setup.height(f)[c]});
        panel.curves.push_back(std::move(curve));
    }
    fit_height(panel);
    panel.curves.push_back(zero_line(panel));
    add_sample_lines(setup, panel);
    return svg_of({&panel, 1});
}

std::string draw_spectrum_sums(const SpectrumSetup& setup, const std::string&) {
    if (setup.command().model.colours == SpectralColours::empirical) {
        const std::string monitor = setup.command().model.monitor;
        const PlotPanel panels[] = {
            empirical_sums(setup, EmpiricalWhite::illuminant,
                           "r + g + b, " + monitor + ", white is illuminant B"),
            empirical_sums(setup, EmpiricalWhite::monitor,
                           "r + g + b, " + monitor + ", its own white")};
        return svg_of(panels);
    }
    PlotPanel panel = panel_of(setup, "r + g + b, " + setup.title());
    PlotCurve curve{"", plot_colour(0), {}};
    for (const double f : setup.steps(kSteps)) {
        const MonitorRgb rgb = setup.height(f);
        curve.points.push_back({setup.place(f), rgb[0] + rgb[1] + rgb[2]});
    }
    panel.curves.push_back(std::move(curve));
    fit_height(panel);
    panel.curves.push_back(zero_line(panel));
    return svg_of({&panel, 1});
}

}  // namespace dewbow
