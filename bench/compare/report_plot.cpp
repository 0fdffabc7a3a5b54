// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "dewbow/export/plot.h"
#include "report.h"

namespace dewbow::bench {
namespace {

/// A curve joins the settings of one contestant with one N, by rising samples.
struct CurveKey {
    std::string contestant;
    int spectral_samples;
    auto operator<=>(const CurveKey&) const = default;
};
using Curves = std::map<CurveKey, std::vector<PlotPoint>>;

/// Round up or down to 1, 2 or 5 times a power of ten would crowd the labels; a little room does.
constexpr double kRoom = 1.4;

void fit(PlotAxis& axis, double low, double high) {
    axis.logarithmic = true;
    axis.from = low / kRoom;
    axis.to = high * kRoom;
}

PlotPanel panel_of(const std::string& title, const Curves& curves,
                   const std::map<std::string, std::size_t>& colours) {
    PlotPanel panel;
    panel.title = title;
    double low_x = std::numeric_limits<double>::infinity(), high_x = 0.0, low_y = low_x, high_y = 0.0;
    for (const auto& [key, points] : curves) {
        PlotCurve curve;
        curve.label = key.spectral_samples == 0
                          ? key.contestant
                          : fmt::format("{} N {}", key.contestant, key.spectral_samples);
        curve.colour = plot_colour(colours.at(key.contestant));
        curve.points = points;
        for (const PlotPoint& point : points) {
            low_x = std::min(low_x, point.x), high_x = std::max(high_x, point.x);
            low_y = std::min(low_y, point.y), high_y = std::max(high_y, point.y);
            panel.dots.push_back(point);
        }
        panel.curves.push_back(std::move(curve));
    }
    panel.x.label = "CPU time, s";
    panel.y.label = "root mean square error (white = 1)";
    fit(panel.x, low_x, high_x);
    fit(panel.y, low_y, high_y);
    panel.width = 760.0;
    panel.height = 620.0;
    return panel;
}

}  // namespace

std::string plot_of(const Measurements& all, const SceneFacts& scene) {
    Curves truth, limit;
    bool has_limits = false;
    std::map<std::string, std::size_t> colours;
    for (const Result& result : all.results) {
        if (result.scene != scene.name) continue;
        colours.emplace(result.contestant, colours.size());
        const CurveKey key{result.contestant, result.knobs.spectral_samples};
        const MaskErrors& errors = result.over("whole");
        const auto add = [&](Curves& curves, double mse) {
            if (mse > 0.0 && std::isfinite(mse))
                curves[key].push_back({result.cpu_s, std::sqrt(mse)});
        };
        add(truth, errors.truth.mse);
        add(limit, errors.limit ? errors.limit->mse : errors.truth.mse);
        has_limits = has_limits || errors.limit;
    }
    std::vector<PlotPanel> panels;
    if (!truth.empty()) panels.push_back(panel_of(scene.name + ": against the truth", truth, colours));
    if (has_limits)
        panels.push_back(panel_of(scene.name + ": against the contestant's own limit, or the truth if that is its limit", limit, colours));
    return svg_of(panels);
}

}  // namespace dewbow::bench
