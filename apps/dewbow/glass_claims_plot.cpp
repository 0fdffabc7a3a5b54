// SPDX-License-Identifier: Apache-2.0

// What the paper says of glasses at large.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/export/plot.h"
#include "dewbow/optics/absorption_band.h"
#include "dewbow/optics/paper_claims.h"
#include "glass_paper.h"

namespace dewbow {
namespace {

/// Room beside the dots, as a share of what they take.
constexpr double kMargin = 0.04;

/// From below the least to above the greatest of `values`.
void widen(PlotAxis& axis, double IndexAndPower::*value, const std::vector<IndexAndPower>& media) {
    const auto [least, most] =
        std::minmax_element(media.begin(), media.end(),
                            [&](const auto& a, const auto& b) { return a.*value < b.*value; });
    const double margin = kMargin * ((*most).*value - (*least).*value);
    axis.from = (*least).*value - margin;
    axis.to = (*most).*value + margin;
}

PlotPanel power_panel() {
    PlotPanel panel;
    panel.title = fmt::format("Dispersive power of all glasses, r = {:.2f}",
                              power_and_density("").correlation);
    panel.x.label = "n_D";
    panel.y.label = "w = (n_F − n_C)/(n_D − 1)";
    const std::vector<IndexAndPower> media = indices_and_powers("");
    for (const auto& [n_D, w] : media) panel.dots.push_back({n_D, w});
    widen(panel.x, &IndexAndPower::n_D, media);
    widen(panel.y, &IndexAndPower::w, media);
    return panel;
}

/// An oscillator such as one of Fig. 3.1, wide enough to be seen.
constexpr AbsorptionBand kBand{0.35, 1000.0 * unit::nm, 0.08};
constexpr double kLeastX = 0.4, kMostX = 1.8, kLeastShown = -0.2, kMostShown = 3.0;

template <class Value>
PlotCurve band_curve(const std::string& label, std::size_t colour, bool dashed,
                     const Value& value) {
    PlotCurve curve{label, plot_colour(colour), {}, dashed};
    for (double x = kLeastX; x <= kMostX; x += 0.002) {
        const double y = value(kBand.c / x);
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
    const AbsorptionBand undamped{kBand.b, kBand.c, 0.0};
    const auto n = [](Wavelength l) { return index_near(kBand, l).real(); };
    const auto sellmeier = [&](Wavelength l) {
        const std::complex<double> index = index_near(undamped, l);
        return index.real() > 0.0 ? index.real() : double(NAN);
    };
    panel.curves.push_back(band_curve("Sellmeier", 1, true, sellmeier));
    panel.curves.push_back(
        band_curve("k", 2, false, [](Wavelength l) { return index_near(kBand, l).imag(); }));
    panel.curves.push_back(band_curve("n", 0, false, n));
    PlotCurve anomalous{"", plot_colour(3), {}, false, 5.0};
    for (double x = kLeastX; x <= kMostX; x += 0.002) {
        const bool falls = n(kBand.c / (x + 1e-3)) < n(kBand.c / (x - 1e-3));
        anomalous.points.push_back({x, falls ? n(kBand.c / x) : NAN});
    }
    panel.curves.push_back(std::move(anomalous));
    panel.marks.push_back({{1.0, n(kBand.c)}, "anomalous", plot_colour(3)});
    return panel;
}

}  // namespace

std::string glass_claims_plot() {
    const PlotPanel panels[] = {power_panel(), band_panel()};
    return svg_of(panels);
}

}  // namespace dewbow
