// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/paper/errata_parts.h"
#include "dewbow/rainbow/paper/fog_table.h"

namespace dewbow::errata {
namespace {

constexpr Wavelength kSodium = 589.3 * unit::nm;

PaperMethod with(PaperWater water, bool divide_by_air) {
    PaperMethod method;
    method.water = water;
    method.divide_by_air = divide_by_air;
    return method;
}

double cauchy(double nm) {
    return paper_index(with(PaperWater::cauchy, false), nm * unit::nm).value;
}
double water_in_air(double nm) {
    return paper_index(with(PaperWater::iapws, false), nm * unit::nm).value;
}
/// Cauchy's index less that of water at 20 °C in air.
double excess(double nm) { return cauchy(nm) - water_in_air(nm); }

ErratumCurve excess_curve(double from_nm, double to_nm) {
    ErratumCurve curve{"as published", {}, {}, true};
    for (double nm = from_nm; nm <= to_nm; nm += 1.0) {
        curve.x.push_back(nm);
        curve.y.push_back(1e4 * excess(nm));
    }
    return curve;
}

ErratumCurve level(const char* label, double from, double to, double y) {
    return {label, {from, to}, {y, y}, false};
}

double bow_radius_deg(const PaperMethod& method, Wavelength lambda, int p) {
    return descartes_ray(paper_index(method, lambda), p).radius().to(unit::deg);
}

}  // namespace

Erratum cauchy_fit() {
    constexpr double kFrom = 405.0, kTo = 670.0;
    double least = 1.0, most = -1.0, square = 0.0;
    int count = 0;
    for (double nm = kFrom; nm <= kTo; nm += 0.5, ++count) {
        least = std::min(least, excess(nm)), most = std::max(most, excess(nm));
        square += excess(nm) * excess(nm);
    }
    const double claimed = 1e-4, span = cauchy(kFrom) - cauchy(kTo);
    Erratum e;
    e.name = "E12", e.subject = "Cauchy's formula for water";
    e.paper_says =
        "a = 1.3239, b = 3116.3 agree with measured indices within ±0.0001, or 0.8 of "
        "one per cent, over 405 to 670 nm";
    e.right =
        "within ±0.0002 of water at 20 °C relative to air; 0.8 % is of the index's variation "
        "over the range, not of the index";
    e.rows = {{"greatest error over 405-670 nm", "1e-4", 1e4 * claimed, 1e4 * most},
              {"least error over 405-670 nm", "1e-4", -1e4 * claimed, 1e4 * least},
              {"rms error over 405-670 nm", "1e-4", 1e4 * claimed, 1e4 * std::sqrt(square / count)},
              {"0.0001 over the index", "%", 0.8, 100.0 * claimed / cauchy(kSodium.to(unit::nm))},
              {"0.0001 over the index's variation", "%", 0.8, 100.0 * claimed / span}};
    e.x_label = "wavelength (nm)", e.y_label = "index less IAPWS at 20 °C in air (1e-4)";
    e.curves = {excess_curve(kFrom, kTo), level("+0.0001", kFrom, kTo, 1.0),
                level("−0.0001", kFrom, kTo, -1.0)};
    return e;
}

Erratum air_counted_twice() {
    const PaperMethod published = with(PaperWater::cauchy, true);
    const PaperMethod right = with(PaperWater::cauchy, false);
    const PaperMethod measured = with(PaperWater::iapws, false);
    Erratum e;
    e.name = "E13", e.subject = "air counted twice";
    e.paper_says = "1.0003 for air, although the table behind a and b is relative to air already";
    e.right = "no division: or an index against vacuum (IAPWS, Daimon & Masumura) over that of air";
    for (int p : {2, 3}) {
        const std::string bow = p == 2 ? "primary" : "secondary";
        const double was = bow_radius_deg(published, kSodium, p);
        const double is = bow_radius_deg(right, kSodium, p);
        e.rows.push_back({"radius of the " + bow + ", 589.3 nm", "deg", was, is});
        e.rows.push_back({"the same with IAPWS at 20 °C in air", "deg", was,
                          bow_radius_deg(measured, kSodium, p)});
        e.rows.push_back({"shift of the " + bow, "deg", was - is, 0.0});
        ErratumCurve curve{bow, {}, {}, true};
        for (double nm = 380.0; nm <= 800.0; nm += 5.0) {
            curve.x.push_back(nm);
            curve.y.push_back(bow_radius_deg(published, nm * unit::nm, p) -
                              bow_radius_deg(right, nm * unit::nm, p));
        }
        e.curves.push_back(curve);
    }
    e.x_label = "wavelength (nm)", e.y_label = "shift of the bow's radius (deg)";
    e.curves.push_back(level("right", 380.0, 800.0, 0.0));
    return e;
}

Erratum beyond_the_fit() {
    Erratum e;
    e.name = "E22", e.subject = "Cauchy's formula beyond its data";
    e.paper_says = "±0.0001, for a simulation over 380 to 800 nm";
    e.right = "the fit holds over 405 to 670 nm only; beyond, the error grows to five times that";
    for (double nm : {388.0, 767.0, 800.0})
        e.rows.push_back(
            {"error at " + std::to_string(int(nm)) + " nm", "1e-4", 1.0, 1e4 * excess(nm)});
    const auto shift = [](double nm) {
        return bow_radius_deg(with(PaperWater::cauchy, false), nm * unit::nm, 3) -
               bow_radius_deg(with(PaperWater::iapws, false), nm * unit::nm, 3);
    };
    e.rows.push_back({"shift of the secondary by it at 767 nm", "deg", shift(767.0), 0.0});
    e.x_label = "wavelength (nm)", e.y_label = "index less IAPWS at 20 °C in air (1e-4)";
    e.curves = {excess_curve(380.0, 800.0), level("+0.0001", 380.0, 800.0, 1.0),
                level("−0.0001", 380.0, 800.0, -1.0)};
    return e;
}

}  // namespace dewbow::errata
