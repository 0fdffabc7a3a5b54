// SPDX-License-Identifier: Apache-2.0

// Rays through a drop, and by how much they turn: the bow is where that is least.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dewbow/export/plot.h"
#include "dewbow/rainbow/drop_ray.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kRays = 11, kCircleSteps = 180, kCurveSteps = 400;
/// Of the panel around the drop, in radii; in the proportion of its area's sides.
constexpr double kLeft = -3.7, kRight = 1.5, kHalfHeight = 1.8;
/// Longer than the panel.
constexpr double kFar = 8.0;
constexpr const char *kWaterColour = "#7aa5c8", *kRayColour = "#9a9a9a";
constexpr std::size_t kMostOrders = 3;

PlotCurve circle() {
    PlotCurve curve;
    curve.colour = kWaterColour;
    for (int k = 0; k <= kCircleSteps; ++k) {
        const double phi = 2.0 * kPi * k / kCircleSteps;
        curve.points.push_back({std::cos(phi), std::sin(phi)});
    }
    return curve;
}

/// From the left at height b, along `p` chords, and out.
PlotCurve path(double b, RelativeIndex n, int p) {
    const DropRay ray = drop_ray(b, n);
    PlotCurve curve;
    curve.points.push_back({-kFar, b});
    double phi = kPi - ray.incidence.to(unit::rad);
    for (int chord = 0; chord <= p; ++chord) {
        curve.points.push_back({std::cos(phi), std::sin(phi)});
        if (chord < p) phi -= kPi - 2.0 * ray.refraction.to(unit::rad);
    }
    const double turned = -deviation(ray, p).to(unit::rad);
    const PlotPoint out = curve.points.back();
    curve.points.push_back({out.x + kFar * std::cos(turned), out.y + kFar * std::sin(turned)});
    return curve;
}

PlotPanel drop_panel(RelativeIndex n, const DescartesRay& bow) {
    PlotPanel panel;
    panel.title = fmt::format(
        "Order {}: {} inside the drop, n = {:.4f}", bow.p,
        bow.p == 2 ? "one reflection" : fmt::format("{} reflections", bow.p - 1), n.value);
    panel.x = {"radii of the drop; light comes from the left", kLeft, kRight};
    panel.y = {"impact parameter b", -kHalfHeight, kHalfHeight};
    panel.curves.push_back(circle());
    for (int k = 0; k < kRays; ++k) {
        panel.curves.push_back(path((k + 0.5) / kRays, n, bow.p));
        panel.curves.back().colour = kRayColour;
        panel.curves.back().width = 1.0;
    }
    panel.curves.push_back(path(bow.impact_parameter, n, bow.p));
    panel.curves.back().colour = plot_colour(1);
    return panel;
}

PlotPanel deflection_panel(RelativeIndex n, const DescartesRay& bow) {
    PlotPanel panel;
    panel.title = fmt::format("Deflection D(b), order {}", bow.p);
    PlotCurve curve;
    curve.colour = plot_colour(0);
    double highest = 0.0;
    for (int k = 0; k <= kCurveSteps; ++k) {
        const double b = double(k) / kCurveSteps;
        const double degrees = deviation(drop_ray(b, n), bow.p).to(unit::deg);
        curve.points.push_back({b, degrees});
        highest = std::max(highest, degrees);
    }
    const double least = bow.deviation.to(unit::deg);
    panel.x = {"impact parameter b, in radii of the drop", 0.0, 1.0};
    panel.y = {"deflection (°)", least - 0.15 * (highest - least), highest};
    panel.curves.push_back(curve);
    panel.marks.push_back({{bow.impact_parameter, least},
                           fmt::format("least: {:.2f}° at b = {:.3f}", least, bow.impact_parameter),
                           plot_colour(1)});
    return panel;
}

}  // namespace

std::string draw_rays(RainbowTables& tables, const std::string&) {
    const TableRequest& request = tables.setup().request;
    const Wavelength lambda = request.wavelengths.empty() ? kSodium : request.wavelengths.front();
    const RelativeIndex n = request.optics.index(lambda);
    std::vector<PlotPanel> panels;
    for (const int p : request.orders.empty() ? Orders{2} : request.orders) {
        if (panels.size() >= 2 * kMostOrders) break;
        const DescartesRay bow = descartes_ray(n, p);
        panels.push_back(drop_panel(n, bow));
        panels.push_back(deflection_panel(n, bow));
    }
    return svg_of(panels);
}

}  // namespace dewbow
