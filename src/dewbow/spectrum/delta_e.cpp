// SPDX-License-Identifier: Apache-2.0

// delta_e_2000 of display.h.

#include <cmath>
#include <numbers>

#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/lab.h"

namespace dewbow {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double power_7(double v) { return v * v * v * v * v * v * v; }
double chroma(double a, double b) { return std::hypot(a, b); }

/// √(C⁷ / (C⁷ + 25⁷))
double chroma_weight(double c) { return std::sqrt(power_7(c) / (power_7(c) + power_7(25.0))); }

/// Degrees in [0, 360); 0 for a neutral colour.
double hue_deg(double a, double b) {
    if (a == 0.0 && b == 0.0) return 0.0;
    const double h = std::atan2(b, a) / kDegree;
    return h < 0.0 ? h + 360.0 : h;
}

/// Lightness, chroma and hue with a* stretched near grey: L′, C′, h′ of the paper.
struct LightnessChromaHue {
    double l, c, h_deg;
};
LightnessChromaHue stretched(const Colour<CieLab>& lab, double g) {
    const double a = (1.0 + g) * lab[1];
    return {lab[0], chroma(a, lab[2]), hue_deg(a, lab[2])};
}

/// From hue 1 to hue 2 the short way round, in [−180, 180].  [eq. 10]
double hue_difference_deg(const LightnessChromaHue& p, const LightnessChromaHue& q) {
    if (p.c * q.c == 0.0) return 0.0;
    const double d = q.h_deg - p.h_deg;
    return d > 180.0 ? d - 360.0 : d < -180.0 ? d + 360.0 : d;
}

/// The middle of two hues on the short way round.  [eq. 14]
double mean_hue_deg(const LightnessChromaHue& p, const LightnessChromaHue& q) {
    const double sum = p.h_deg + q.h_deg;
    if (p.c * q.c == 0.0) return sum;
    if (std::abs(p.h_deg - q.h_deg) <= 180.0) return 0.5 * sum;
    return sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0);
}

/// T of the paper: how the tolerance of hue depends on hue.  [eq. 15]
double hue_tolerance(double h_deg) {
    const auto cosine = [](double deg) { return std::cos(deg * kDegree); };
    return 1.0 - 0.17 * cosine(h_deg - 30.0) + 0.24 * cosine(2.0 * h_deg) +
           0.32 * cosine(3.0 * h_deg + 6.0) - 0.20 * cosine(4.0 * h_deg - 63.0);
}

/// R_T of the paper: chroma and hue are not independent in the blue.  [eq. 16, 17, 21]
double rotation(double h_deg, double c) {
    const double away = (h_deg - 275.0) / 25.0;
    const double turn_deg = 30.0 * std::exp(-away * away);
    return -2.0 * chroma_weight(c) * std::sin(2.0 * turn_deg * kDegree);
}

}  // namespace

double delta_e_2000(Colour<Xyz> first, Colour<Xyz> second, Colour<Xyz> white_xyz) {
    const Colour<CieLab> lab_1 = lab_from_xyz(first, white_xyz);
    const Colour<CieLab> lab_2 = lab_from_xyz(second, white_xyz);
    const double mean_chroma = 0.5 * (chroma(lab_1[1], lab_1[2]) + chroma(lab_2[1], lab_2[2]));
    const double g = 0.5 * (1.0 - chroma_weight(mean_chroma));
    const LightnessChromaHue p = stretched(lab_1, g);
    const LightnessChromaHue q = stretched(lab_2, g);

    const double mean_c = 0.5 * (p.c + q.c);
    const double mean_h_deg = mean_hue_deg(p, q);
    const double from_50 = 0.5 * (p.l + q.l) - 50.0;
    const double scale_l = 1.0 + 0.015 * from_50 * from_50 / std::sqrt(20.0 + from_50 * from_50);
    const double scale_c = 1.0 + 0.045 * mean_c;
    const double scale_h = 1.0 + 0.015 * mean_c * hue_tolerance(mean_h_deg);

    const double dl = (q.l - p.l) / scale_l;
    const double dc = (q.c - p.c) / scale_c;
    const double half_turn = 0.5 * hue_difference_deg(p, q) * kDegree;
    const double dh = 2.0 * std::sqrt(p.c * q.c) * std::sin(half_turn) / scale_h;
    return std::sqrt(dl * dl + dc * dc + dh * dh + rotation(mean_h_deg, mean_c) * dc * dh);
}

}  // namespace dewbow
