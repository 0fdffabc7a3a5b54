// SPDX-License-Identifier: Apache-2.0
#include "glass_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/export/plot.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

constexpr double kStep_nm = 2.0;
/// The diagram shows what solids and liquids have; gases would stretch it.
constexpr double kLeastV = 15.0, kMostV = 100.0, kLeastN = 1.3, kMostN = 2.2;
constexpr double kBandFrom_nm = 390.0, kBandTo_nm = 730.0;

/// The colour of a wavelength as a screen shows it: desaturated until it fits, darkened at the
/// ends.
std::string colour_of(double lambda_nm) {
    const auto xyz = cie_xyz_bar(lambda_nm);
    const double x = xyz[0], y = xyz[1], z = xyz[2];
    double rgb[3] = {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
                     0.0557 * x - 0.2040 * y + 1.0570 * z};  // linear sRGB [IEC 61966-2-1]
    const double white = std::max(0.0, -std::min({rgb[0], rgb[1], rgb[2]}));
    const double most = std::max({rgb[0], rgb[1], rgb[2], 1.0 - white}) + white;
    int code[3];
    for (int i = 0; i < 3; ++i)
        code[i] =
            static_cast<int>(std::lround(255.0 * std::pow((rgb[i] + white) / most, 1.0 / 2.2)));
    return fmt::format("#{:02x}{:02x}{:02x}", code[0], code[1], code[2]);
}

/// The parts of a glass's curve: measured in full, continued in dashes.
void add_curves(const GlassFacts& facts, const std::string& colour, PlotPanel& panel) {
    std::vector<PlotCurve> parts;
    bool measured = false;
    for (double l = kLambdaMin_nm; l <= kLambdaMax_nm; l += kStep_nm) {
        const bool here = facts.has_data_at(l);
        if (parts.empty() || here != measured) {
            const auto last = parts.empty() ? std::vector<PlotPoint>{}
                                            : std::vector<PlotPoint>{parts.back().points.back()};
            parts.push_back({{}, colour, last, !here});
        }
        measured = here;
        parts.back().points.push_back({l, facts.index(l)});
    }
    parts.back().label = facts.glass.name;
    for (PlotCurve& part : parts) panel.curves.push_back(std::move(part));
}

/// A margin of a twelfth around what the curves reach, with room for the colours below.
void fit_axis(PlotPanel& panel) {
    double low = 100.0, high = 0.0;
    for (const PlotCurve& curve : panel.curves)
        for (const PlotPoint& p : curve.points) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
    const double margin = std::max((high - low) / 12.0, 1e-5);
    panel.y.from = low - 1.3 * margin;
    panel.y.to = high + margin;
}

PlotPanel index_panel(std::span<const GlassFacts> glasses) {
    PlotPanel panel;
    panel.title = "Index of refraction";
    panel.x = {"vacuum wavelength λ (nm)", kLambdaMin_nm, kLambdaMax_nm};
    const bool all_vacuum =
        std::all_of(glasses.begin(), glasses.end(), [](const GlassFacts& facts) {
            return facts.glass.data.reference == IndexReference::vacuum;
        });
    panel.y.label = all_vacuum ? "n, against vacuum" : "n, against air";
    for (std::size_t i = 0; i < glasses.size(); ++i) add_curves(glasses[i], plot_colour(i), panel);
    for (double l = kBandFrom_nm; l <= kBandTo_nm; l += 10.0)
        panel.band.push_back({l, colour_of(l)});
    fit_axis(panel);
    return panel;
}

PlotPanel abbe_panel(std::span<const GlassFacts> glasses) {
    PlotPanel panel;
    panel.title = "Abbe diagram";
    panel.x = {"Abbe number V_d", kMostV, kLeastV};
    panel.y = {"n_d", kLeastN, kMostN};
    for (const Glass& glass : glass_catalogue())
        if (glass.v_d > 0.0) panel.dots.push_back({glass.v_d, glass.n_d});
    for (std::size_t i = 0; i < glasses.size(); ++i) {
        const GlassFacts& facts = glasses[i];
        if (!std::isfinite(facts.V_d)) continue;
        panel.x.from = std::max(panel.x.from, 1.05 * facts.V_d);
        panel.x.to = std::min(panel.x.to, 0.9 * facts.V_d);
        panel.y.from = std::min(panel.y.from, facts.n_d - 0.05);
        panel.y.to = std::max(panel.y.to, facts.n_d + 0.05);
        panel.marks.push_back({{facts.V_d, facts.n_d}, facts.glass.name, plot_colour(i)});
    }
    return panel;
}

}  // namespace

std::string glass_plot(std::span<const GlassFacts> glasses) {
    const PlotPanel panels[] = {index_panel(glasses), abbe_panel(glasses)};
    return svg_of(panels);
}

}  // namespace dewbow
