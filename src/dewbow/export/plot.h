// SPDX-License-Identifier: Apache-2.0
#pragma once

// Plots as SVG: panels side by side, each with axes, a picture, curves and labelled marks.

#include <cstddef>
#include <optional>
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
    bool logarithmic = false;     ///< from and to are greater than 0
    bool ticks = true;
};

struct PlotCurve {
    std::string label;  ///< stands right of its end; may be empty
    std::string colour;
    std::vector<PlotPoint> points;  ///< points that are not finite leave a gap
    bool dashed = false;
    double width = 2.0;  ///< in pixels
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

/// A picture that fills the area from corner to corner.
struct PlotPicture {
    std::string png;                                          ///< the file's bytes
    double left = 0.0, right = 1.0, bottom = 0.0, top = 1.0;  ///< where its sides lie on the axes
};

struct PlotPanel {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
    std::vector<PlotPoint> dots;  ///< small and grey
    std::vector<PlotMark> marks;
    std::vector<PlotBandStop> band;                     ///< by rising x; may be empty
    std::optional<PlotPicture> picture = std::nullopt;  ///< below all else
    double width = 620.0, height = 470.0;               ///< in pixels, with what stands around it
};

/// The panels as one picture, in rows of `columns` (0: a single row), each as high as its highest.
/// Labels are put where none covers another as far as there is room.
std::string svg_of(std::span<const PlotPanel> panels, std::size_t columns = 0);

/// Colours that are told apart by all eyes, for curve `index`.        [Okabe & Ito 2008, darkened]
std::string plot_colour(std::size_t index);

/// Powers of ten within [low, high], 0 < low, at most about twelve of them; where there are
/// fewer than two, also their doubles and fivefolds.
std::vector<double> decade_ticks(double low, double high);

/// Round numbers within [low, high], about `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

}  // namespace dewbow
