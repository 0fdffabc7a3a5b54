// SPDX-License-Identifier: Apache-2.0

// Where does spectral aliasing show? "Only in pathological scenes", says Musgrave 1989, 4.1. Here a
// white source on black is seen through a prism, and an eye compares the picture of N samples with
// that of infinitely many.
//
//     bench_aliasing_map [aliasing-map.csv] [aliasing-map.svg]
//     bench_aliasing_map --check
//
// The table has, for each prism, source and N, the largest CIEDE2000 difference of fixed samples,
// and the root mean square of the noise of jittered and correlated ones. The plot shows how large
// the spread may be before N fixed samples show. With --check some places of the map are rendered
// instead.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "aliasing/dispersed_source.h"
#include "aliasing/prisms.h"
#include "aliasing/rendered.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/parallel.h"
#include "dewbow/export/plot.h"

namespace dewbow::bench {
namespace {

constexpr std::array<int, 5> kCounts{5, 7, 13, 31, 100};
/// Pixels too small to be seen, and those of a picture of 512 lines over 40°, in arc minutes.
constexpr double kFinePixel = 0.25, kPixelOf1989 = 40.0 * 60.0 / 512.0;
/// Noise is that of pixels of one arc minute, of 16 sets each: 4 × 4 rays.
constexpr double kNoisePixel = 1.0;
constexpr int kSets = 16;
constexpr Angle kApex = 60.0 * unit::deg;

struct Source {
    const char* name;
    double width_arcmin;
};
constexpr std::array<Source, 8> kSources{{{"a hair", 0.5},
                                          {"a slit", 2.0},
                                          {"a wide slit", 5.0},
                                          {"a candle", 15.0},
                                          {"the sun", 32.0},
                                          {"a bulb", 90.0},
                                          {"a lamp", 300.0},
                                          {"a window", 1200.0}}};

struct Row {
    const char* index;
    Prism prism;
    Source source;
};

std::string csv_lines(const Row& row) {
    std::string lines;
    const double spread = row.prism.spread_arcmin, width = row.source.width_arcmin;
    for (const int n : kCounts)
        lines += fmt::format("{},{},{:.4f},{:.2f},{},{:g},{},{:.3f},{:.3f},{:.3f},{:.3f}\n",
                             row.prism.name, row.index, row.prism.w, spread, row.source.name, width,
                             n, aliasing({spread, width, kFinePixel}, n),
                             aliasing({spread, width, kPixelOf1989}, n),
                             noise({spread, width, kNoisePixel}, n, false, kSets),
                             noise({spread, width, kNoisePixel}, n, true, kSets));
    return lines;
}

std::string csv() {
    std::vector<Row> rows;
    for (const auto& [index, prisms] :
         {std::pair{"paper", paper_prisms(kApex)}, std::pair{"real", real_prisms(kApex)}})
        for (const Prism& prism : prisms)
            for (const Source& source : kSources) rows.push_back({index, prism, source});
    std::vector<std::string> parts(rows.size());
    parallel_for(rows.size(), [&](std::size_t i) { parts[i] = csv_lines(rows[i]); });
    std::string text =
        "prism,index,dispersive_power,spread_arcmin,source,source_arcmin,samples,fixed_de2000,"
        "fixed_de2000_512_lines,jittered_rms_de2000_16_sets,correlated_rms_de2000_16_sets\n";
    for (const std::string& part : parts) text += part;
    return text;
}

/// The spread at which `samples` fixed ones begin to show.
double visible_from(double width, double pixel, int samples) {
    constexpr double kLeast = 1.0, kMost = 6000.0, kFactor = 1.2, kPrecision = 1.005;
    const auto shows = [&](double spread) {
        return aliasing({spread, width, pixel}, samples) >= kJustVisible;
    };
    double high = kLeast;
    while (high < kMost && !shows(high)) high *= kFactor;
    double low = high / kFactor;
    while (high / low > kPrecision) {
        const double middle = std::sqrt(low * high);
        (shows(middle) ? high : low) = middle;
    }
    return high;
}

PlotPanel map_panel(const std::string& title, double pixel) {
    constexpr std::size_t kWidths = 48;
    constexpr double kNarrowest = 0.5, kWidest = 1200.0, kLeastSpread = 3.0, kMostSpread = 2400.0;
    PlotPanel panel;
    panel.title = title;
    panel.x = {"width of the source in arc minutes", kNarrowest, kWidest, true};
    panel.y = {"spread from 800 to 380 nm in arc minutes", kLeastSpread, kMostSpread, true};
    panel.width = 700.0, panel.height = 560.0;
    for (std::size_t i = 0; i < kCounts.size(); ++i) {
        PlotCurve curve{fmt::format("{}", kCounts[i]), plot_colour(i), {}};
        curve.points.resize(kWidths);
        parallel_for(kWidths, [&](std::size_t k) {
            const double share = double(k) / (kWidths - 1);
            const double width = kNarrowest * std::pow(kWidest / kNarrowest, share);
            curve.points[k] = {width, visible_from(width, pixel, kCounts[i])};
        });
        panel.curves.push_back(std::move(curve));
    }
    const auto mark = [&](const std::vector<Prism>& prisms, double at, const char* what) {
        for (const Prism& prism : prisms)
            panel.marks.push_back({{at, prism.spread_arcmin}, prism.name + what, "#555"});
    };
    mark(paper_prisms(kApex), 0.6, ", paper's line");
    mark(real_prisms(kApex), 9.0, "");
    return panel;
}

PlotPanel white_noise_panel() {
    PlotPanel panel;
    panel.title = "Jittered samples: noise of white";
    panel.x = {"sets of samples a pixel of 1'", 1.0, 256.0, true};
    panel.y = {"rms CIEDE2000", 0.01, 10.0, true};
    panel.width = 460.0, panel.height = 560.0;
    for (std::size_t i = 0; i < kCounts.size(); ++i) {
        PlotCurve curve{fmt::format("{}", kCounts[i]), plot_colour(i), {}};
        for (int sets = 1; sets <= 256; sets *= 2)
            curve.points.push_back(
                {double(sets), noise_of_white(kCounts[i], false, sets, kNoisePixel)});
        panel.curves.push_back(std::move(curve));
    }
    panel.curves.push_back(
        {"just visible", "#888", {{1.0, kJustVisible}, {256.0, kJustVisible}}, true, 1.0});
    return panel;
}

/// From which spread N samples show, over all widths of the source.
void print_thresholds(const PlotPanel& map) {
    std::printf("%s\n", map.title.c_str());
    for (const PlotCurve& curve : map.curves) {
        const auto [least, most] =
            std::minmax_element(curve.points.begin(), curve.points.end(),
                                [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
        std::printf("    %3s samples show from a spread of %.1f' to %.1f'\n", curve.label.c_str(),
                    least->y, most->y);
    }
}

void run(const std::string& table, const std::string& plot) {
    write_file_atomically(table, csv());
    const std::array<PlotPanel, 3> panels{
        map_panel("Below its line, N fixed samples do not show", kFinePixel),
        map_panel("The same in a picture of 512 lines over 40°", kPixelOf1989),
        white_noise_panel()};
    for (const PlotPanel& map : {panels[0], panels[1]}) print_thresholds(map);
    write_file_atomically(plot, svg_of(panels));
}

/// Wider spectra are longer in the violet than in the red, which the closed form does not know.
constexpr double kEvenSpread = 60.0;

void check() {
    std::printf(
        "| prism, paper's line | source | samples | closed form | rendered |\n"
        "|---|---|---|---|---|\n");
    for (const Prism& prism : paper_prisms(kApex)) {
        if (prism.spread_arcmin > kEvenSpread) break;
        for (const Source& source : {kSources[1], kSources[4], kSources[6]})
            for (const int samples : {7, 13, 31}) {
                const Sight sight{prism.spread_arcmin, source.width_arcmin, kNoisePixel};
                std::printf(
                    "| %s | %g' | %d | %.2f | %.2f |\n", prism.name.c_str(), source.width_arcmin,
                    samples, aliasing(sight, samples),
                    rendered_aliasing(prism, kApex, source.width_arcmin, kNoisePixel, samples));
                std::fflush(stdout);
            }
    }
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string_view(argv[1]) == "--check")
            dewbow::bench::check();
        else
            dewbow::bench::run(argc > 1 ? argv[1] : "aliasing-map.csv",
                               argc > 2 ? argv[2] : "aliasing-map.svg");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_aliasing_map: %s\n", error.what());
        return 1;
    }
}
