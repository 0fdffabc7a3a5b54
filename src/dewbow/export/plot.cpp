// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace dewbow {
namespace {

// Sizes in pixels of the picture.
constexpr double kLeft = 78, kRight = 22, kTop = 46, kBottom = 64;
constexpr double kFont = 13, kTitleFont = 16, kBandHeight = 10, kTick = 6;
constexpr double kLetterWidth = 0.58;  ///< of the font's size: the mean of a sans serif
constexpr int kTicks = 7;
constexpr double kLineHeight = 15, kLabelGap = 6;
/// Points of a curve that lie nearer to a line through others are left out.
constexpr double kFinest = 0.1;
constexpr double kMostDecades = 12;

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

/// True if the "_" at `i` stands between one letter and one letter or digit: that of "n_d".
bool is_subscript(const std::string& text, std::size_t i) {
    const auto in_word = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    const bool one_before = i > 0 && in_word(i - 1) && (i == 1 || !in_word(i - 2));
    return text[i] == '_' && one_before && in_word(i + 1) && !in_word(i + 2);
}

/// "(n_F − n_C)" with F and C as indices.
std::string with_subscripts(const std::string& text) {
    std::string result;
    std::size_t done = 0;
    const auto add_up_to = [&](std::size_t end) {
        const std::string part = escaped(text.substr(done, end - done));
        const bool is_below = done > 0 && !part.empty();
        result += is_below ? fmt::format("<tspan dy=\"-4\" xml:space=\"preserve\">{}</tspan>", part)
                           : part;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_subscript(text, i)) continue;
        add_up_to(i);
        result += fmt::format("<tspan dy=\"4\" font-size=\"10\">{}</tspan>", text[i + 1]);
        done = i + 2;
    }
    add_up_to(text.size());
    return result;
}

double text_width(const std::string& text) {
    const auto letters = std::count_if(text.begin(), text.end(),
                                       [](char c) { return (c & 0xC0) != 0x80; });  // UTF-8
    return kLetterWidth * kFont * static_cast<double>(letters);
}

std::string base64(const std::string& bytes) {
    constexpr const char* kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kLetters[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

/// "10⁻³", "2·10⁻³", "20"
std::string power_text(double value) {
    constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (value >= 0.1 && value < 1e4) return fmt::format("{:g}", value);
    const auto exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const double factor = value / std::pow(10.0, exponent);
    std::string text = factor < 1.5 ? "10" : fmt::format("{:.0f}·10", factor);
    if (exponent < 0) text += "⁻";
    for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
    return text;
}

double distance_to_line(PlotPoint p, PlotPoint a, PlotPoint b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0.0) return std::hypot(p.x - a.x, p.y - a.y);
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

/// The points of a line without those that nobody would miss: each that is left out lies within
/// kFinest of the line through its neighbours that stay.           [Ramer 1972; Douglas & Peucker]
std::vector<PlotPoint> simplified(const std::vector<PlotPoint>& points) {
    std::vector<bool> stays(points.size(), false);
    stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double most = kFinest;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance_to_line(points[i], points[first], points[last]);
            if (d > most) most = d, farthest = i;
        }
        if (farthest == first) continue;
        stays[farthest] = true;
        open.insert(open.end(), {{first, farthest}, {farthest, last}});
    }
    std::vector<PlotPoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (stays[i]) kept.push_back(points[i]);
    return kept;
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
                       x, y, anchor, colour, with_subscripts(text));
}

/// What the labels of curves take.
double label_margin(const PlotPanel& panel) {
    double widest = 0.0;
    for (const PlotCurve& curve : panel.curves) widest = std::max(widest, text_width(curve.label));
    return widest > 0.0 ? widest + 2.0 * kLabelGap : kRight;
}

class PanelWriter {
public:
    PanelWriter(const PlotPanel& panel, double left, std::size_t number)
        : panel_(panel),
          number_(number),
          area_{left + kLeft, kTop, left + panel.width - label_margin(panel),
                panel.height - kBottom} {}

    std::string write() {
        out_ += fmt::format(
            "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{}\" "
            "fill=\"{}\">{}</text>\n",
            0.5 * (area_.left + area_.right), kTop - 18, kTitleFont, kInk, escaped(panel_.title));
        write_picture();
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
    /// 0 at the axis's beginning, 1 at its end.
    static double share_of(const PlotAxis& axis, double value) {
        if (!axis.logarithmic) return (value - axis.from) / (axis.to - axis.from);
        return std::log(value / axis.from) / std::log(axis.to / axis.from);
    }
    double x_of(double x) const {
        return area_.left + share_of(panel_.x, x) * (area_.right - area_.left);
    }
    double y_of(double y) const {
        return area_.bottom - share_of(panel_.y, y) * (area_.bottom - area_.top);
    }

    static std::vector<double> ticks_of(const PlotAxis& axis) {
        if (!axis.ticks) return {};
        const double low = std::min(axis.from, axis.to), high = std::max(axis.from, axis.to);
        return axis.logarithmic ? decade_ticks(low, high) : round_ticks(low, high, kTicks);
    }
    static std::string tick_text(const PlotAxis& axis, const std::vector<double>& ticks,
                                 double tick) {
        if (axis.logarithmic) return power_text(tick);
        return fmt::format("{:.{}f}", tick, decimals_of(ticks));
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
            if (!panel_.picture) line(x_of(x), area_.top, x_of(x), area_.bottom, kGrid);
            line(x_of(x), area_.bottom, x_of(x), area_.bottom + kTick, kInk);
            out_ += text_element(x_of(x), area_.bottom + kTick + kFont + 2, "middle",
                                 tick_text(panel_.x, x_ticks, x), kInk);
        }
        for (const double y : y_ticks) {
            if (!panel_.picture) line(area_.left, y_of(y), area_.right, y_of(y), kGrid);
            line(area_.left - kTick, y_of(y), area_.left, y_of(y), kInk);
            out_ += text_element(area_.left - kTick - 4, y_of(y) + 0.35 * kFont, "end",
                                 tick_text(panel_.y, y_ticks, y), kInk);
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
            x, y, kInk, with_subscripts(panel_.y.label));
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

    void write_picture() {
        if (!panel_.picture) return;
        const PlotPicture& p = *panel_.picture;
        const double left = x_of(p.left), right = x_of(p.right);
        const double top = y_of(p.top), bottom = y_of(p.bottom);
        out_ += fmt::format(
            "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
            "preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>\n",
            left, top, right - left, bottom - top, base64(p.png));
    }

    /// Each run of points that are finite is a line of its own.
    void write_curve(const PlotCurve& curve) {
        std::vector<PlotPoint> run;
        for (const PlotPoint& p : curve.points) {
            const PlotPoint at{x_of(p.x), y_of(p.y)};
            if (std::isfinite(at.x) && std::isfinite(at.y)) {
                run.push_back(at);
                continue;
            }
            write_line(curve, run);
            run.clear();
        }
        write_line(curve, run);
    }

    void write_line(const PlotCurve& curve, const std::vector<PlotPoint>& run) {
        if (run.size() < 2) return;
        std::string points;
        for (const PlotPoint& p : simplified(run))
            points += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
        out_ += fmt::format(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
            "stroke-linejoin=\"round\"{}/>\n",
            points, curve.colour, curve.width, curve.dashed ? " stroke-dasharray=\"5 4\"" : "");
    }

    /// Right of the area, at the height of the curves' ends, pushed apart where they are too near.
    void write_curve_labels() {
        struct Label {
            const PlotCurve* curve;
            double y;
        };
        std::vector<Label> labels;
        for (const PlotCurve& curve : panel_.curves) {
            const auto last =
                std::find_if(curve.points.rbegin(), curve.points.rend(), [&](const PlotPoint& p) {
                    return std::isfinite(x_of(p.x)) && std::isfinite(y_of(p.y));
                });
            if (curve.label.empty() || last == curve.points.rend()) continue;
            labels.push_back({&curve, std::clamp(y_of(last->y), area_.top, area_.bottom)});
        }
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

std::vector<double> decade_ticks(double low, double high) {
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::ceil(std::log10(high) - 1e-9);
    const double step = std::ceil((last - first) / kMostDecades);
    const auto inside = [&](double value) {
        return value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
    };
    std::vector<double> powers, all;
    for (double k = first; k <= last; k += std::max(step, 1.0)) {
        if (inside(std::pow(10.0, k))) powers.push_back(std::pow(10.0, k));
        for (const double factor : {1.0, 2.0, 5.0})
            if (inside(factor * std::pow(10.0, k))) all.push_back(factor * std::pow(10.0, k));
    }
    return powers.size() < 2 ? all : powers;
}

std::string plot_colour(std::size_t index) {
    constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#00845f", "#a0478a",
                                                  "#8a6d00", "#2f88c4", "#000000"};
    return kColours[index % kColours.size()];
}

std::string svg_of(std::span<const PlotPanel> panels, std::size_t columns) {
    if (columns == 0) columns = panels.size();
    double width = 0.0, height = 0.0;
    std::string rows;
    for (std::size_t first = 0; first < panels.size(); first += columns) {
        double left = 0.0, highest = 0.0;
        rows += fmt::format("<g transform=\"translate(0 {:.0f})\">\n", height);
        for (std::size_t i = first; i < std::min(first + columns, panels.size()); ++i) {
            rows += PanelWriter(panels[i], left, i).write();
            left += panels[i].width;
            highest = std::max(highest, panels[i].height);
        }
        rows += "</g>\n";
        width = std::max(width, left);
        height += highest;
    }
    const std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Verdana, sans-serif\" "
        "font-size=\"{2}\">\n<style>text {{ paint-order: stroke; stroke: white; stroke-width: 3px; "
        "stroke-linejoin: round }}</style>\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n",
        width, height, kFont);
    return out + rows + "</svg>\n";
}

}  // namespace dewbow
