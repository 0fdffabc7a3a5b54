// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/rainbow/paper/errata_parts.h"
#include "dewbow/rainbow/paper/fog_table.h"

namespace dewbow::errata {
namespace {

constexpr double kBucket_deg = 0.1;
constexpr double kLimbDarkening = 0.6;

/// Root mean square distance from the middle.
double rms_deg(const std::vector<double>& taps, double bucket_deg) {
    double square = 0.0;
    for (std::size_t k = 0; k < taps.size(); ++k) {
        const double x = (double(k) - double(taps.size() / 2)) * bucket_deg;
        square += taps[k] * x * x;
    }
    return std::sqrt(square);
}

/// Weight per degree, as steps.
ErratumCurve steps(const char* label, const std::vector<double>& taps, double bucket_deg,
                   bool as_published) {
    ErratumCurve curve{label, {}, {}, as_published};
    const double first = -0.5 * double(taps.size()) * bucket_deg;
    const auto add = [&](double x, double y) {
        curve.x.push_back(x);
        curve.y.push_back(y);
    };
    add(first, 0.0);
    for (std::size_t k = 0; k < taps.size(); ++k) {
        add(first + double(k) * bucket_deg, taps[k] / bucket_deg);
        add(first + double(k + 1) * bucket_deg, taps[k] / bucket_deg);
    }
    add(-first, 0.0);
    return curve;
}

double tap(const std::vector<double>& taps, int k) {
    const int at = k + int(taps.size()) / 2;
    return at < int(taps.size()) ? taps[std::size_t(at)] : 0.0;
}

}  // namespace

Erratum kernel_of_the_sun() {
    const std::vector<double> published = sun_kernel(SunKernel::five_entries);
    const std::vector<double> right = sun_kernel(SunKernel::disc);
    const SunDisc darkened{kSunRadius, kLimbDarkening};
    const std::vector<double> limb = projection_kernel(darkened, kPaperBucket);
    constexpr double kFine_deg = 0.002;
    const auto width = [&](double u) {
        return rms_deg(projection_kernel({kSunRadius, u}, kFine_deg * unit::deg), kFine_deg);
    };
    Erratum e;
    e.name = "E16", e.subject = "the kernel of the sun";
    e.paper_says = "a semicircle five buckets of 0.1° wide, taken at their middles";
    e.right = "a disc of radius 0.2666° integrated over the buckets: seven entries";
    for (int k = 0; k <= 3; ++k)
        e.rows.push_back({"entry at " + std::to_string(k) + " buckets from the middle", "",
                          tap(published, k), tap(right, k)});
    for (int k = 0; k <= 3; ++k)
        e.rows.push_back({"the same, limb darkened by u = 0.6, " + std::to_string(k) + " buckets",
                          "", tap(published, k), tap(limb, k)});
    e.rows.push_back({"rms width of the disc", "deg", rms_deg(published, kBucket_deg), width(0.0)});
    e.rows.push_back({"rms width of the disc, limb darkened", "deg",
                      rms_deg(published, kBucket_deg), width(kLimbDarkening)});
    PaperMethod method = paper_method_corrected();
    const auto buckets = paper_intensities(method, 589.3 * unit::nm);
    const auto peak = [&](const std::vector<double>& kernel) {
        const auto smeared = convolve_mirrored(buckets, kernel);
        return *std::max_element(smeared.begin() + 300, smeared.begin() + 450);
    };
    e.rows.push_back({"primary's peak, one wavelength, over the right one", "",
                      peak(published) / peak(right), 1.0});
    e.x_label = "distance from the middle of the sun (deg)", e.y_label = "weight (per deg)";
    e.curves = {steps("as published", published, kBucket_deg, true),
                steps("seven entries", right, kBucket_deg, false),
                steps("limb darkened", projection_kernel(darkened, kFine_deg * unit::deg),
                      kFine_deg, false)};
    return e;
}

}  // namespace dewbow::errata
