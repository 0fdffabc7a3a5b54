// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewbow {
namespace {

// Sizes in pixels of the picture.
constexpr double kWidth = 620, kHeight = 470;
constexpr double kLeft = 78, kRight = 22, kTop = 46, kBottom = 64;
constexpr double kFont = 13, kTitleFont = 16, kBandHeight = 10, kTick = 6;
constexpr double kLetterWidth = 0.58;  ///< of the font's size: the mean of a sans serif
constexpr int kTicks = 7;
constexpr double kLineHeight = 15, kLabelGap = 6;

constexpr const char* kInk = "#333";
constexpr const char* kGrid = "#e6e6e6";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result.push_back(c);
    }
    return result;
}

/// "n_d" with its last letter as an index.
std::string with_subscript(const std::string& text) {
    const std::size_t at = text.size() < 3 ? std::string::npos : text.size() - 2;
    if (at == std::string::npos || text[at] != '_') return escaped(text);
    return fmt::format("{}<tspan dy=\"4\" font-size=\"10\">{}</tspan>", escaped(text.substr(0, at)),
                       escaped(text.substr(at + 1)));
}

double text_width(const std::string& text) {
    const auto letters = std::count_if(text.begin(), text.end(),
                                       [](char c) { return (c & 0xC0) != 0x80; });  // UTF-8
    return kLetterWidth * kFont * static_cast<double>(letters);
}

struct Box {
    double left, top, right, bottom;
    bool overlaps(const Box& o) const {
        return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
    }
};

std::string text_element(double x, double y, const char* anchor, const std::string& text,
                         const std::string& colour) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                       x, y, anchor, colour, with_subscript(text));
}

/// What the labels of curves take.
double label_margin(const PlotPanel& panel) {
    double widest = 0.0;
    for (const PlotCurve& curve : panel.curves) widest = std::max(widest, text_width(curve.label));
    return widest > 0.0 ? widest + kLabelGap : kRight;
}

class PanelWriter {
public:
    PanelWriter(const PlotPanel& panel, double left, std::size_t number)
        : panel_(panel),
          number_(number),
          area_{left + kLeft, kTop, left + kWidth - label_margin(panel), kHeight - kBottom} {}

    std::string write() {
        out_ += fmt::format(
            "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{}\" "
            "fill=\"{}\">{}</text>\n",
            0.5 * (area_.left + area_.right), kTop - 18, kTitleFont, kInk, escaped(panel_.title));
        write_axes();
        write_band();
        out_ += fmt::format("<g clip-path=\"url(#area{})\">\n", number_);
        for (const PlotPoint& dot : panel_.dots)
            out_ +=
                fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.7\" fill=\"#b5b5b5\"/>\n",
                            x_of(dot.x), y_of(dot.y));
        for (const PlotCurve& curve : panel_.curves) write_curve(curve);
        out_ += "</g>\n";
        for (const PlotMark& mark : panel_.marks) reserve_dot(mark);
        for (const PlotMark& mark : panel_.marks) write_mark(mark);
        write_curve_labels();
        return out_;
    }

private:
    double x_of(double x) const {
        const PlotAxis& axis = panel_.x;
        return area_.left + (x - axis.from) / (axis.to - axis.from) * (area_.right - area_.left);
    }
    double y_of(double y) const {
        const PlotAxis& axis = panel_.y;
        return area_.bottom - (y - axis.from) / (axis.to - axis.from) * (area_.bottom - area_.top);
    }

    static std::vector<double> ticks_of(const PlotAxis& axis) {
        return round_ticks(std::min(axis.from, axis.to), std::max(axis.from, axis.to), kTicks);
    }
    /// As many decimals as tell the ticks apart.
    static int decimals_of(const std::vector<double>& ticks) {
        if (ticks.size() < 2) return 0;
        return std::max(0, static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)));
    }

    void line(double x0, double y0, double x1, double y1, const char* colour) {
        out_ += fmt::format(
            "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
            "stroke=\"{}\"/>\n",
            x0, y0, x1, y1, colour);
    }

    void write_axes() {
        out_ += fmt::format(
            "<clipPath id=\"area{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" "
            "width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n",
            number_, area_.left, area_.top, area_.right - area_.left, area_.bottom - area_.top);
        const auto x_ticks = ticks_of(panel_.x), y_ticks = ticks_of(panel_.y);
        for (const double x : x_ticks) {
            line(x_of(x), area_.top, x_of(x), area_.bottom, kGrid);
            line(x_of(x), area_.bottom, x_of(x), area_.bottom + kTick, kInk);
            out_ += text_element(x_of(x), area_.bottom + kTick + kFont + 2, "middle",
                                 fmt::format("{:.{}f}", x, decimals_of(x_ticks)), kInk);
        }
        for (const double y : y_ticks) {
            line(area_.left, y_of(y), area_.right, y_of(y), kGrid);
            line(area_.left - kTick, y_of(y), area_.left, y_of(y), kInk);
            out_ += text_element(area_.left - kTick - 4, y_of(y) + 0.35 * kFont, "end",
                                 fmt::format("{:.{}f}", y, decimals_of(y_ticks)), kInk);
        }
        out_ += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
            "fill=\"none\" stroke=\"{}\"/>\n",
            area_.left, area_.top, area_.right - area_.left, area_.bottom - area_.top, kInk);
        out_ += text_element(0.5 * (area_.left + area_.right), area_.bottom + 48, "middle",
                             panel_.x.label, kInk);
        const double x = area_.left - kLeft + 20, y = 0.5 * (area_.top + area_.bottom);
        out_ += fmt::format(
            "<text transform=\"translate({:.1f},{:.1f}) rotate(-90)\" "
            "text-anchor=\"middle\" fill=\"{}\">{}</text>\n",
            x, y, kInk, with_subscript(panel_.y.label));
    }

    void write_band() {
        if (panel_.band.size() < 2) return;
        const double first = panel_.band.front().x, last = panel_.band.back().x;
        out_ += fmt::format("<linearGradient id=\"band{}\">\n", number_);
        for (const PlotBandStop& stop : panel_.band)
            out_ += fmt::format("<stop offset=\"{:.4f}\" stop-color=\"{}\"/>\n",
                                (stop.x - first) / (last - first), stop.colour);
        out_ += fmt::format(
            "</linearGradient>\n<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
            "height=\"{}\" fill=\"url(#band{})\"/>\n",
            x_of(first), area_.bottom - kBandHeight, x_of(last) - x_of(first), kBandHeight,
            number_);
        taken_.push_back({area_.left, area_.bottom - kBandHeight, area_.right, area_.bottom});
    }

    void write_curve(const PlotCurve& curve) {
        std::string points;
        for (const PlotPoint& p : curve.points)
            points += fmt::format("{:.2f},{:.2f} ", x_of(p.x), y_of(p.y));
        out_ += fmt::format(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
            "stroke-linejoin=\"round\"{}/>\n",
            points, curve.colour, curve.dashed ? " stroke-dasharray=\"5 4\"" : "");
    }

    /// Right of the area, at the height of the curves' ends, pushed apart where they are too near.
    void write_curve_labels() {
        struct Label {
            const PlotCurve* curve;
            double y;
        };
        std::vector<Label> labels;
        for (const PlotCurve& curve : panel_.curves)
            if (!curve.label.empty() && !curve.points.empty())
                labels.push_back({&curve, y_of(curve.points.back().y)});
        std::stable_sort(labels.begin(), labels.end(),
                         [](const Label& a, const Label& b) { return a.y < b.y; });
        for (std::size_t i = 1; i < labels.size(); ++i)
            labels[i].y = std::max(labels[i].y, labels[i - 1].y + kLineHeight);
        double lowest = area_.bottom;
        for (std::size_t i = labels.size(); i-- > 0; lowest = labels[i].y - kLineHeight)
            labels[i].y = std::min(labels[i].y, lowest);
        for (const Label& label : labels)
            out_ += text_element(area_.right + kLabelGap, label.y + 0.35 * kFont, "start",
                                 label.curve->label, label.curve->colour);
    }

    void reserve_dot(const PlotMark& mark) {
        const double x = x_of(mark.at.x), y = y_of(mark.at.y);
        taken_.push_back({x - 5, y - 5, x + 5, y + 5});
    }

    void write_mark(const PlotMark& mark) {
        const double x = x_of(mark.at.x), y = y_of(mark.at.y), width = text_width(mark.label);
        out_ += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\" "
            "stroke=\"white\"/>\n",
            x, y, mark.colour);
        for (double distance = 8; distance < 90; distance += 9) {
            const std::array<Box, 4> places{
                Box{x + distance, y - 6, x + distance + width, y + 8},
                Box{x - distance - width, y - 6, x - distance, y + 8},
                Box{x - 0.5 * width, y - distance - 14, x + 0.5 * width, y - distance},
                Box{x - 0.5 * width, y + distance, x + 0.5 * width, y + distance + 14}};
            for (const Box& box : places) {
                if (!is_free(box)) continue;
                taken_.push_back(box);
                out_ += text_element(box.left, box.bottom - 4, "start", mark.label, mark.colour);
                return;
            }
        }
    }

    bool is_free(const Box& box) const {
        if (box.left < area_.left + 2 || box.right > area_.right - 2 || box.top < area_.top + 2 ||
            box.bottom > area_.bottom - 2)
            return false;
        return std::none_of(taken_.begin(), taken_.end(),
                            [&](const Box& other) { return box.overlaps(other); });
    }

    const PlotPanel& panel_;
    const std::size_t number_;
    const Box area_;
    std::vector<Box> taken_;
    std::string out_;
};

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
    if (!(high > low)) return {low};
    const double rough = (high - low) / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough * 0.999) step = factor * power;
    std::vector<double> ticks;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
        ticks.push_back(k * step + 0.0);
    return ticks;
}

std::string plot_colour(std::size_t index) {
    constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#00845f", "#a0478a",
                                                  "#8a6d00", "#2f88c4", "#000000"};
    return kColours[index % kColours.size()];
}

std::string svg_of(std::span<const PlotPanel> panels) {
    const double width = kWidth * static_cast<double>(panels.size());
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Verdana, sans-serif\" "
        "font-size=\"{2}\">\n<style>text {{ paint-order: stroke; stroke: white; stroke-width: 3px; "
        "stroke-linejoin: round }}</style>\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n",
        width, kHeight, kFont);
    for (std::size_t i = 0; i < panels.size(); ++i)
        out += PanelWriter(panels[i], kWidth * static_cast<double>(i), i).write();
    return out + "</svg>\n";
}

}  // namespace dewbow
