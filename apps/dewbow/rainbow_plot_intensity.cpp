// SPDX-License-Identifier: Apache-2.0

// Phase functions by angle, models or wavelengths side by side; and their degree of polarisation.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/export/plot.h"
#include "rainbow_degrees.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr std::size_t kMostWavelengths = 12;
/// Of the logarithmic axis, below its highest value.
constexpr double kDeepest = 1e-7;
constexpr double kWidth = 980.0;
/// Models beyond so many are dashed: they often lie on others.
constexpr std::size_t kSolid = 2;
constexpr const char* kIntensityLabel = "Q_sca P: 4π dσ/dΩ over the drops’ cross section";
constexpr const char* kAngleLabel = "scattering angle θ (°); the antisolar point is at 180°";

using Value = double (*)(const Intensities&);

Value value_of(Polarisation polarisation) {
    switch (polarisation) {
        case Polarisation::perpendicular:
            return [](const Intensities& p) { return p.perpendicular; };
        case Polarisation::parallel:
            return [](const Intensities& p) { return p.parallel; };
        case Polarisation::unpolarised:
            break;
    }
    return [](const Intensities& p) { return p.unpolarised(); };
}

double degree_of_polarisation(const Intensities& p) {
    return (p.perpendicular - p.parallel) / (p.perpendicular + p.parallel);
}

/// What a curve shows: a value of the phase functions, times Q_sca where models are to be compared
/// that scatter more or less light in all.
struct Shown {
    Value value;
    bool absolute = true;
};

PlotCurve curve_of(const ScatteringTable& table, std::size_t wavelength, const Shown& shown) {
    PlotCurve curve;
    const double scale = shown.absolute ? table.efficiencies[wavelength].scattering : 1.0;
    for (std::size_t i = 0; i < table.angles.size(); ++i)
        curve.points.push_back(
            {degrees_of(table.angles[i]), scale * shown.value(table.at(i, wavelength))});
    curve.width = 1.5;
    return curve;
}

/// "debye p = 2, 3"
std::string model_label(const RainbowSetup& setup, const std::string& model) {
    const Orders orders = setup.request_for(model, {}, {}).orders;
    std::string text = model;
    for (const int p : orders) text += fmt::format("{}{}", text == model ? " p = " : ", ", p);
    return text;
}

/// One for each model and wavelength.
std::vector<PlotCurve> curves_of(RainbowTables& tables, const std::vector<Angle>& angles,
                                 const Shown& shown) {
    std::vector<PlotCurve> curves;
    for (const std::string& model : tables.setup().models) {
        const ScatteringTable& table = tables.get(model, {kSodium}, angles);
        if (table.wavelengths.size() > kMostWavelengths)
            throw InputError(fmt::format("{} wavelengths in one plot; at most {} are told apart",
                                         table.wavelengths.size(), kMostWavelengths));
        for (std::size_t j = 0; j < table.wavelengths.size(); ++j) {
            curves.push_back(curve_of(table, j, shown));
            PlotCurve& curve = curves.back();
            curve.colour = plot_colour(curves.size() - 1);
            curve.dashed = curves.size() > kSolid && tables.setup().models.size() > 1;
            const std::string nm = fmt::format("{:g} nm", table.wavelengths[j].to(unit::nm));
            const std::string label = model_label(tables.setup(), model);
            curve.label = table.wavelengths.size() == 1       ? label
                          : tables.setup().models.size() == 1 ? nm
                                                              : label + ", " + nm;
        }
    }
    return curves;
}

struct Extremes {
    double low = INFINITY, high = 0.0;
};
/// Of what is positive and finite, at angles from `from` on.
Extremes extremes_of(const std::vector<PlotCurve>& curves, double from) {
    Extremes found;
    for (const PlotCurve& curve : curves)
        for (const PlotPoint& p : curve.points) {
            if (p.x < from || !std::isfinite(p.y) || p.y <= 0.0) continue;
            found.low = std::min(found.low, p.y);
            found.high = std::max(found.high, p.y);
        }
    return found.high > 0.0 ? found : Extremes{0.1, 1.0};
}

std::string title_of(const RainbowTables& tables, const ScatteringTable& table) {
    const RainbowSetup& setup = tables.setup();
    std::string title = setup.drops;
    if (table.wavelengths.size() == 1) {
        const Wavelength lambda = table.wavelengths.front();
        title += fmt::format(", {:g} nm, n = {:.5g}", lambda.to(unit::nm),
                             setup.request.optics.index(lambda).value);
    }
    const double radius = degrees_of(setup.request.disc.radius);
    title += radius > 0.0 ? fmt::format(", sun of radius {:.3g}°", radius) : ", point sun";
    if (setup.polarisation != Polarisation::unpolarised)
        title += ", " + polarisation_names()[static_cast<std::size_t>(setup.polarisation)];
    return title;
}

PlotPanel panel_of(RainbowTables& tables, const std::vector<Angle>& angles, const Shown& shown) {
    PlotPanel panel;
    panel.curves = curves_of(tables, angles, shown);
    panel.width = kWidth;
    const ScatteringTable& table = tables.get({kSodium}, angles);
    panel.title = title_of(tables, table);
    if (table.angles.size() < 2) throw InputError("a plot needs two angles or more");
    panel.x = {kAngleLabel, degrees_of(table.angles.front()), degrees_of(table.angles.back())};
    return panel;
}

}  // namespace

std::string draw_intensity(RainbowTables& tables, const std::string&) {
    PlotPanel panel = panel_of(tables, whole_circle(), {value_of(tables.setup().polarisation)});
    const Extremes found = extremes_of(panel.curves, 0.0);
    const double low = std::max(found.low, kDeepest * found.high);
    panel.y = {kIntensityLabel, std::pow(10.0, std::floor(std::log10(low))),
               std::pow(10.0, std::ceil(std::log10(found.high))), true};
    return svg_of({&panel, 1});
}

std::string draw_intensity_linear(RainbowTables& tables, const std::string&) {
    PlotPanel panel = panel_of(tables, around_the_bows(), {value_of(tables.setup().polarisation)});
    const double backward = panel.x.to > 90.0 ? 90.0 : 0.0;  // the forward peak hides all else
    panel.y = {kIntensityLabel, 0.0, 1.08 * extremes_of(panel.curves, backward).high};
    return svg_of({&panel, 1});
}

std::string draw_polarisation(RainbowTables& tables, const std::string&) {
    PlotPanel panel = panel_of(tables, whole_circle(), {degree_of_polarisation, false});
    panel.y = {"degree of polarisation (P⊥ − P∥) / (P⊥ + P∥)", -1.0, 1.0};
    return svg_of({&panel, 1});
}

}  // namespace dewbow
