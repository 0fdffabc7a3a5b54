// SPDX-License-Identifier: Apache-2.0

// What the paper says of glasses at large.

#include <fmt/format.h>

#include <cmath>

#include "dewbow/export/plot.h"
#include "dewbow/optics/absorption_band.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"
#include "dewbow/optics/paper_claims.h"
#include "glass_paper.h"

namespace dewbow {
namespace {

/// The diagram shows what solids and liquids have.
constexpr double kLeastN = 1.3, kMostN = 2.2, kMostW = 0.07;

PlotPanel power_panel() {
    PlotPanel panel;
    panel.title = fmt::format("Dispersive power of all glasses, r = {:.2f}",
                              power_and_density("").correlation);
    panel.x = {"n_D", kLeastN, kMostN};
    panel.y = {"w = (n_F − n_C)/(n_D − 1)", 0.0, kMostW};
    for (const Glass& glass : glass_catalogue()) {
        const DispersionPtr dispersion = make_dispersion(glass.data);
        const double n_D = ((*dispersion)(kLineD) / (*air())(kLineD)).value;
        const double w = dispersive_power(index_in_air(dispersion));
        if (n_D > kLeastN && n_D < kMostN && w > 0.0 && w < kMostW) panel.dots.push_back({n_D, w});
    }
    return panel;
}

/// An oscillator such as one of Fig. 3.1, wide enough to be seen.
constexpr AbsorptionBand kBand{0.35, 1.0, 0.08};
constexpr double kLeastX = 0.4, kMostX = 1.8, kLeastShown = -0.2, kMostShown = 3.0;

template <class Value>
PlotCurve band_curve(const std::string& label, std::size_t colour, bool dashed,
                     const Value& value) {
    PlotCurve curve{label, plot_colour(colour), {}, dashed};
    for (double x = kLeastX; x <= kMostX; x += 0.002) {
        const double y = value(kBand.c_um / x);
        curve.points.push_back({x, y < kMostShown && y > kLeastShown ? y : NAN});
    }
    return curve;
}

/// Fig. 3.1: n rises with the frequency but for where it absorbs; Sellmeier's pole.
PlotPanel band_panel() {
    PlotPanel panel;
    panel.title = "Fig. 3.1: an absorption band, and Sellmeier's pole";
    panel.x = {"frequency / that of the band", kLeastX, kMostX};
    panel.y = {"n, k", kLeastShown, kMostShown};
    const AbsorptionBand undamped{kBand.b, kBand.c_um, 0.0};
    const auto n = [](double l) { return index_near(kBand, l).real(); };
    const auto sellmeier = [&](double l) {
        const std::complex<double> index = index_near(undamped, l);
        return index.real() > 0.0 ? index.real() : double(NAN);
    };
    panel.curves.push_back(band_curve("Sellmeier", 1, true, sellmeier));
    panel.curves.push_back(
        band_curve("k", 2, false, [](double l) { return index_near(kBand, l).imag(); }));
    panel.curves.push_back(band_curve("n", 0, false, n));
    PlotCurve anomalous{"", plot_colour(3), {}, false, 5.0};
    for (double x = kLeastX; x <= kMostX; x += 0.002) {
        const bool falls = n(kBand.c_um / (x + 1e-3)) < n(kBand.c_um / (x - 1e-3));
        anomalous.points.push_back({x, falls ? n(kBand.c_um / x) : NAN});
    }
    panel.curves.push_back(std::move(anomalous));
    panel.marks.push_back({{1.0, n(kBand.c_um)}, "anomalous", plot_colour(3)});
    return panel;
}

}  // namespace

std::string glass_claims_plot() {
    const PlotPanel panels[] = {power_panel(), band_panel()};
    return svg_of(panels);
}

}  // namespace dewbow
