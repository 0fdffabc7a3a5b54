// SPDX-License-Identifier: Apache-2.0

// What sets of samples make of white: by common offset, as a histogram over random sets, or, of
// fixed samples, the tint that is divided out, by their number.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "spectrum_plots.h"
#include "spectrum_white.h"

namespace dewbow {
namespace {

constexpr int kFewest = 3, kMost = 40;  ///< fixed samples
constexpr int kBins = 60;
constexpr double kHeadroom = 1.08;
/// Points that a curve over the offset needs.
constexpr int kMostPoints = 2048;

/// A table of numbers: x and a value of each channel.
struct Table {
    std::string title, x_label, y_label, x_name;
    std::vector<double> x;
    std::vector<std::array<double, 3>> y;
};

Table over_offset(const SpectrumWhite& white) {
    Table table{"White by common offset",
                "common offset, in intervals",
                "sum of the set minus white (%)",
                "offset",
                {},
                {}};
    const std::size_t count = white.sums.size();
    const std::size_t stride = std::max<std::size_t>(1, count / kMostPoints);
    for (std::size_t i = 0; i < count; i += stride) {
        const MonitorRgb& sum = white.sums[i];
        table.x.push_back((double(i) + 0.5) / double(count));
        table.y.push_back({100.0 * (sum[0] - 1.0), 100.0 * (sum[1] - 1.0), 100.0 * (sum[2] - 1.0)});
    }
    return table;
}

Table histogram(const SpectrumWhite& white) {
    Table table{fmt::format("White in {} sets", white.sums.size()),
                "sum of the set (1 is white)",
                "sets per bin (%)",
                "sum",
                {},
                {}};
    double least = 1.0, greatest = 1.0;
    for (const WhiteChannel& channel : white.channels) {
        least = std::min(least, channel.least);
        greatest = std::max(greatest, channel.greatest);
    }
    const double width = std::max(greatest - least, 1e-9) / kBins;
    for (int i = 0; i < kBins; ++i) table.x.push_back(least + (i + 0.5) * width);
    table.y.resize(kBins);
    for (const MonitorRgb& sum : white.sums)
        for (std::size_t c = 0; c < 3; ++c) {
            const int bin = std::clamp(int((sum[c] - least) / width), 0, kBins - 1);
            table.y[std::size_t(bin)][c] += 100.0 / double(white.sums.size());
        }
    return table;
}

Table tint_by_number(const SpectrumSetup& setup) {
    Table table{"Tint of fixed samples",
                "number of samples",
                "sum of the set minus white (%)",
                "samples",
                {},
                {}};
    const SpectralModelPtr model = make_spectral_model(setup.command().model);
    for (int samples = kFewest; samples <= kMost; ++samples) {
        // Jittered ones may have any number: their tint is asked for, not their sum.
        const PreparedSpectralSampling prepared(
            model, {samples, Jitter::colour, false, setup.command().sampling.tailored});
        const MonitorRgb tint = prepared.raw_tint();
        table.x.push_back(samples);
        table.y.push_back(
            {100.0 * (tint[0] - 1.0), 100.0 * (tint[1] - 1.0), 100.0 * (tint[2] - 1.0)});
    }
    return table;
}

Table table_of(const SpectrumSetup& setup) {
    const SpectralSampling& sampling = setup.command().sampling;
    if (!colours_move(sampling.jitter)) return tint_by_number(setup);
    const SpectrumWhite white = measure_white(setup);
    return sampling.correlated ? over_offset(white) : histogram(white);
}

std::string csv_of(const Table& table, const SpectrumSetup& setup) {
    std::string text =
        fmt::format("# {}; {}; {}\n# {}\n{},red,green,blue\n", table.title, setup.title(),
                    setup.sampling_title(), table.y_label, table.x_name);
    for (std::size_t i = 0; i < table.x.size(); ++i)
        text +=
            fmt::format("{},{},{},{}\n", table.x[i], table.y[i][0], table.y[i][1], table.y[i][2]);
    return text;
}

PlotPanel panel_of(const Table& table, const SpectrumSetup& setup) {
    PlotPanel panel;
    panel.title = table.title + ": " + setup.title();
    panel.x = {table.x_label, table.x.front(), table.x.back()};
    panel.y.label = table.y_label;
    double least = 0.0, most = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        PlotCurve curve{kChannelNames[c], kChannelColours[c], {}};
        for (std::size_t i = 0; i < table.x.size(); ++i) {
            curve.points.push_back({table.x[i], table.y[i][c]});
            least = std::min(least, table.y[i][c]);
            most = std::max(most, table.y[i][c]);
        }
        panel.curves.push_back(std::move(curve));
    }
    // A residual that is nought is shown on a scale on which one would be seen.
    constexpr double kLeastRange = 0.1;
    panel.y.to = std::max(kHeadroom * most, kLeastRange);
    panel.y.from =
        panel.y.to > kLeastRange ? kHeadroom * least : std::min(kHeadroom * least, -kLeastRange);
    panel.curves.push_back({"", "#888888", {{panel.x.from, 0.0}, {panel.x.to, 0.0}}, false, 1.0});
    return panel;
}

}  // namespace

std::string draw_spectrum_white(const SpectrumSetup& setup, const std::string& ending) {
    const Table table = table_of(setup);
    if (ending == ".csv") return csv_of(table, setup);
    const PlotPanel panel = panel_of(table, setup);
    return svg_of({&panel, 1});
}

}  // namespace dewbow
