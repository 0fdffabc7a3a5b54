// SPDX-License-Identifier: Apache-2.0
#pragma once

// Plots as SVG: panels side by side, each with axes, curves and labelled marks.

#include <span>
#include <string>
#include <vector>

namespace dewbow {

struct PlotPoint {
    double x = 0.0, y = 0.0;
};

struct PlotAxis {
    std::string label;            ///< with its unit
    double from = 0.0, to = 1.0;  ///< left and right, bottom and top; from > to turns it round
};

struct PlotCurve {
    std::string label;  ///< stands right of its end; may be empty
    std::string colour;
    std::vector<PlotPoint> points;
    bool dashed = false;
};

/// A dot with a label.
struct PlotMark {
    PlotPoint at;
    std::string label, colour;
};

/// A colour of the strip above the x axis.
struct PlotBandStop {
    double x = 0.0;
    std::string colour;
};

struct PlotPanel {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
    std::vector<PlotPoint> dots;  ///< small and grey
    std::vector<PlotMark> marks;
    std::vector<PlotBandStop> band;  ///< by rising x; may be empty
};

/// The panels as one picture. Labels are put where none covers another as far as there is room.
std::string svg_of(std::span<const PlotPanel> panels);

/// Colours that are told apart by all eyes, for curve `index`.        [Okabe & Ito 2008, darkened]
std::string plot_colour(std::size_t index);

/// Round numbers within [low, high], about `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

}  // namespace dewbow
