// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/rainbow/paper/errata_parts.h"
#include "dewbow/rainbow/paper/fog.h"
#include "dewbow/rainbow/paper/fog_table.h"
#include "dewbow/rainbow/paper/impressionistic.h"

namespace dewbow::errata {
namespace {

constexpr std::size_t kGreen = 1;
/// Rain one constant deep: h d = 1.
constexpr Length kDepth = 1.0 * unit::m;
constexpr InverseLength kFogConstant = 1.0 / kDepth;

std::vector<double> green(const std::vector<Colour<LinearSrgb>>& colours) {
    std::vector<double> values;
    for (const Colour<LinearSrgb>& colour : colours) values.push_back(colour[kGreen]);
    return values;
}

/// Share of the colour behind that the fog of a transmittance replaces.
ErratumCurve replaced(const char* label, const std::vector<double>& transmittance,
                      bool as_published) {
    ErratumCurve curve{label, {}, {}, as_published};
    for (std::size_t k = 350; k < 570; ++k) {
        curve.x.push_back((double(k) + 0.5) * kPaperBucket.to(unit::deg));
        curve.y.push_back(fog_replacement(kFogConstant, kDepth, transmittance[k]));
    }
    return curve;
}

/// Buckets from the first to `last` that a parameter by name gives a fog.
int rings_drawn(double rainbow_angle, double rainbow_width, int last) {
    bool used[kPaperSamples] = {};
    for (int k = 0; k < last; ++k) {
        const double index =
            published_ring_index(cos((k + 0.5) * kPaperBucket), rainbow_angle, rainbow_width);
        if (index >= 0.0 && index < kPaperSamples) used[int(index)] = true;
    }
    return int(std::count(std::begin(used), std::end(used), true));
}

}  // namespace

Erratum ring_index() {
    const Angle outer = 43.0 * unit::deg, inner = 41.0 * unit::deg;
    const double as_cosine = kPaperSamples / (cos(inner) - cos(outer));
    const int right = rings_drawn(cos(outer), as_cosine, kPaperBuckets);
    Erratum e;
    e.name = "E11", e.subject = "the index into the rings";
    e.paper_says = "index = (DOT − rainbow_angle) · rainbow_width, with an angle and a width";
    e.right =
        "DOT is a cosine: the cosine of the outer radius, and 13 over the difference of the "
        "cosines; or an index by angle";
    e.rows = {
        {"rings drawn, angle and width in degrees", "",
         double(rings_drawn(outer.to(unit::deg), 2.0, kPaperBuckets)), double(right)},
        {"rings drawn, angle and width in radians", "",
         double(rings_drawn(outer.to(unit::rad), (outer - inner).to(unit::rad), kPaperBuckets)),
         double(right)}};
    ErratumCurve by_cosine{"by cosine", {}, {}, true}, by_angle{"by angle", {}, {}, false};
    double most = 0.0;
    for (double r = 41.0; r <= 43.0; r += 0.01) {
        const double excess = published_ring_index(cos(r * unit::deg), cos(outer), as_cosine) -
                              dewbow::ring_index(r * unit::deg, outer, inner);
        most = std::max(most, std::abs(excess));
        by_cosine.x.push_back(r), by_cosine.y.push_back(excess);
        by_angle.x.push_back(r), by_angle.y.push_back(0.0);
    }
    e.rows.push_back({"greatest difference of indices by cosine and by angle", "rings", most, 0.0});
    e.x_label = "angle from the antisolar point (deg)",
    e.y_label = "index less that by angle (rings)";
    e.curves = {by_cosine, by_angle};
    return e;
}

Erratum fog_and_order() {
    PaperMethod method;
    method.rays = 0;
    const FogTable right = make_fog_table(method);
    method.kernel = SunKernel::none;
    const FogTable point = make_fog_table(method);
    const std::vector<double> kernel = sun_kernel(SunKernel::five_entries);
    const std::vector<double> t = green(right.transmittance);
    // As the text's order has it: normalised and inverted, then smeared.
    const std::vector<double> smeared = convolve_mirrored(green(point.transmittance), kernel);
    const std::vector<double> bright = convolve_mirrored(green(point.intensity), kernel);
    const double greatest = *std::max_element(bright.begin() + 350, bright.begin() + 570);
    const double published = 1.0 / *std::min_element(smeared.begin() + 350, smeared.begin() + 570);
    int lost = 0, white = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        lost += std::isinf(smeared[k]) && !std::isinf(t[k]);
        white += fog_replacement(kFogConstant, std::numeric_limits<double>::infinity() * unit::m,
                                 t[k]) == 1.0;
    }
    Erratum e;
    e.name = "E23", e.subject = "fog at infinity, and inverting before smearing";
    e.paper_says =
        "fog replaces everything at infinite distance; tables are normalised and "
        "inverted, and then convolved";
    e.right = "rain has a depth; intensities are convolved, then normalised, then inverted";
    e.rows = {{"sky that infinite rain turns all white, of 180°", "%",
               100.0 * white / kPaperBuckets, 0.0},
              {"buckets with light that smearing 1/I makes fogless", "", double(lost), 0.0},
              {"brightest green of the bow, over that of a point sun", "", published, greatest}};
    e.x_label = "angle from the antisolar point (deg)";
    e.y_label = "green replaced at h d = 1";
    e.curves = {replaced("inverted first", smeared, true), replaced("smeared first", t, false)};
    return e;
}

}  // namespace dewbow::errata
