// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

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

/// Air around the points, a factor.
constexpr double kRoom = 1.4;

void fit(PlotAxis& axis, double low, double high) {
    axis.logarithmic = true;
    axis.from = low / kRoom;
    axis.to = high * kRoom;
}

/// Where there are more contestants than colours, the second of a colour is dashed.
bool has_colour_of_an_earlier(std::size_t number) {
    for (std::size_t earlier = 0; earlier < number; ++earlier)
        if (plot_colour(earlier) == plot_colour(number)) return true;
    return false;
}

PlotPanel panel_of(const std::string& title, const std::string& unit, const Curves& curves,
                   const std::map<std::string, std::size_t>& colours) {
    PlotPanel panel;
    panel.title = title;
    double low_x = std::numeric_limits<double>::infinity(), high_x = 0.0, low_y = low_x,
           high_y = 0.0;
    for (const auto& [key, points] : curves) {
        PlotCurve curve;
        curve.label = key.spectral_samples == 0
                          ? key.contestant
                          : fmt::format("{} N {}", key.contestant, key.spectral_samples);
        const std::size_t number = colours.at(key.contestant);
        curve.colour = plot_colour(number);
        curve.dashed = has_colour_of_an_earlier(number);
        curve.points = points;
        for (const PlotPoint& point : points) {
            low_x = std::min(low_x, point.x), high_x = std::max(high_x, point.x);
            low_y = std::min(low_y, point.y), high_y = std::max(high_y, point.y);
            panel.dots.push_back(point);
        }
        panel.curves.push_back(std::move(curve));
    }
    panel.x.label = "CPU time, s";
    panel.y.label = unit;
    fit(panel.x, low_x, high_x);
    fit(panel.y, low_y, high_y);
    panel.width = 760.0;
    panel.height = 620.0;
    return panel;
}

/// One way of looking at a scene's results.
struct View {
    std::string title, unit;
    double (*error)(const Result& result);
};
double root_of(double mse) { return std::sqrt(mse); }
constexpr const char* kRootUnit = "root mean square error (white = 1)";
const std::vector<View>& views() {
    static const std::vector<View> all = {
        {"against the truth", kRootUnit,
         [](const Result& result) { return root_of(result.over("whole").truth.mse); }},
        {"against its own limit (the truth, if that is its limit)", kRootUnit,
         [](const Result& result) {
             const MaskErrors& errors = result.over("whole");
             return root_of(errors.limit ? errors.limit->mse : errors.truth.mse);
         }},
        {"coloured pixels, against the truth", kRootUnit,
         [](const Result& result) { return root_of(result.over("coloured").truth.mse); }},
        {"FLIP, against the truth", "FLIP",
         [](const Result& result) { return result.over("whole").truth.flip; }},
    };
    return all;
}

}  // namespace

std::string plot_of(const Measurements& all, const SceneFacts& scene) {
    std::map<std::string, std::size_t> colours;
    for (const Result& result : all.results)
        if (result.scene == scene.name) colours.emplace(result.contestant, colours.size());
    std::vector<PlotPanel> panels;
    for (const View& view : views()) {
        Curves curves;
        for (const Result& result : all.results) {
            if (result.scene != scene.name) continue;
            const double error = view.error(result);
            if (error > 0.0 && std::isfinite(error))
                curves[{result.contestant, result.knobs.spectral_samples}].push_back(
                    {result.cpu_s, error});
        }
        if (!curves.empty())
            panels.push_back(panel_of(scene.name + ": " + view.title, view.unit, curves, colours));
    }
    return svg_of(panels, 2);
}

}  // namespace dewbow::bench
