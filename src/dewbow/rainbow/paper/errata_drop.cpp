// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/paper/errata_parts.h"
#include "dewbow/rainbow/paper/fog_table.h"

namespace dewbow::errata {
namespace {

constexpr RelativeIndex kWater{1.333};
constexpr double kBucket_deg = 0.1;

/// Per steradian or per bucket, of one order, smeared by the sun; by angle from the antisolar
/// point.
std::vector<double> sky(int p, RayDensity density, bool per_solid_angle) {
    std::vector<Angle> edges;
    for (int k = 0; k <= kPaperBuckets; ++k) edges.push_back(double(k) * kPaperBucket);
    std::vector<PolarisedFlux> cells(kPaperBuckets);
    add_geometric_flux(kWater, p, edges, cells, density);
    std::vector<double> flux(cells.size());
    for (std::size_t k = 0; k < flux.size(); ++k) {
        const std::size_t cell = cells.size() - 1 - k;
        const double area = cell_solid_angle(edges[cell], edges[cell + 1]).to(unit::sr);
        flux[k] = cells[cell].unpolarised() / (per_solid_angle ? area : 1.0);
    }
    return convolve_mirrored(flux, sun_kernel(SunKernel::disc));
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
    return a;
}

double greatest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

std::vector<double> over(std::vector<double> values, double unit) {
    for (double& v : values) v /= unit;
    return values;
}

/// In the bucket just inside r.
double at(const std::vector<double>& values, double r_deg) {
    return values[std::size_t(std::lround(r_deg / kBucket_deg)) - 1];
}

/// The values between two angles, with gaps where they are 0.
ErratumCurve curve_of(const char* label, const std::vector<double>& values, double from_deg,
                      double to_deg, bool as_published) {
    ErratumCurve curve{label, {}, {}, as_published};
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double r = (double(k) + 0.5) * kBucket_deg;
        if (r < from_deg || r > to_deg) continue;
        curve.x.push_back(r);
        curve.y.push_back(values[k] > 0.0 ? values[k] : std::numeric_limits<double>::quiet_NaN());
    }
    return curve;
}

double all_flux(RayDensity density, int p) {
    const Angle whole[] = {Angle{}, 180.0 * unit::deg};
    std::vector<PolarisedFlux> cell(1);
    add_geometric_flux(kWater, p, whole, cell, density);
    return cell[0].unpolarised();
}

}  // namespace

Erratum geometry() {
    constexpr Wavelength kRed = 700.0 * unit::nm;
    const RelativeIndex red = paper_index(paper_method_corrected(), kRed);
    const double primary = descartes_ray(red, 2).radius().to(unit::deg);
    const double secondary = descartes_ray(red, 3).radius().to(unit::deg);
    const double sun = 2.0 * kSunRadius.to(unit::deg);
    const RelativeIndex violet = paper_index(paper_method_corrected(), 400.0 * unit::nm);
    const auto width = [&](int p) {
        return abs(descartes_ray(red, p).radius() - descartes_ray(violet, p).radius())
            .to(unit::deg);
    };
    const auto by_rays = [](int p) { return sky(p, RayDensity::even_over_disc, true); };
    const std::vector<double> two = by_rays(2), bows = sum(two, by_rays(3));
    const std::vector<double> all = sum(sum(bows, by_rays(0)), sum(by_rays(6), by_rays(7)));
    double band = 0.0;
    int count = 0;
    for (double r = 43.5; r <= 49.0; r += kBucket_deg, ++count) band += at(all, r);
    const double peak = greatest(std::vector<double>(two.begin(), two.begin() + 600));
    Erratum e;
    e.name = "E14", e.subject = "the geometry in words";
    e.paper_says =
        "Alexander's band is 10° wide and no light is returned there; the secondary is "
        "at 52°; the Descartes ray is a point of inflection";
    e.right =
        "7.65° from red to red, 7.1° beside the sun's disc; it holds light reflected outside "
        "and of orders 6 and 7; 50.9° at the sodium line; the deflection is least there";
    e.rows = {{"width of Alexander's band, 700 nm, point sun", "deg", 10.0, secondary - primary},
              {"the same between discs of the sun", "deg", 10.0, secondary - primary - sun},
              {"width of the primary, 400-700 nm, point sun", "deg", 2.0, width(2)},
              {"width of the secondary, 400-700 nm, point sun", "deg", 2.0, width(3)},
              {"light in the band over the primary's peak, rays", "", 0.0, band / count / peak},
              {"radius of the secondary, n = 1.333", "deg", 52.0,
               descartes_ray(kWater, 3).radius().to(unit::deg)},
              {"d²D/db² at the Descartes ray (0 at an inflection)", "rad", 0.0,
               2.0 * descartes_ray(kWater, 2).airy_constant}};
    e.x_label = "angle from the antisolar point (deg)";
    e.y_label = "brightness over the primary's peak", e.logarithmic = true;
    e.curves = {curve_of("as published", over(bows, peak), 36.0, 58.0, true),
                curve_of("orders 0, 6, 7 too", over(all, peak), 36.0, 58.0, false)};
    return e;
}

Erratum ray_weights() {
    const auto published = [](int p) {
        return sky(p, RayDensity::even_in_impact_parameter, false);
    };
    const auto right = [](int p) { return sky(p, RayDensity::even_over_disc, true); };
    // Orders apart: at 70° and 90° only order 3 leaves.
    const double published_peak = greatest(published(2)), right_peak = [&] {
        const std::vector<double> two = right(2);  // but for the axis, where all is one ray
        return *std::max_element(two.begin() + 300, two.end());
    }();
    const auto p2 = over(published(2), published_peak), p3 = over(published(3), published_peak);
    const auto r2 = over(right(2), right_peak), r3 = over(right(3), right_peak);
    const auto peak_of_secondary = [](const std::vector<double>& v) {
        return *std::max_element(v.begin() + 500, v.begin() + 600);
    };
    Erratum e;
    e.name = "E15", e.subject = "rays even in impact parameter, no solid angle";
    e.paper_says = "50,000 rays over the range of impact parameters, summed by angle of emergence";
    e.right = "a drop is a sphere: rays count 2b db, and a bucket is a ring of 2π sin θ dθ";
    e.rows = {
        {"secondary's peak over the primary's", "", peak_of_secondary(p3), peak_of_secondary(r3)}};
    for (double r : {30.0, 20.0})
        e.rows.push_back(
            {"inside the primary at " + std::to_string(int(r)) + "°", "", at(p2, r), at(r2, r)});
    for (double r : {70.0, 90.0})
        e.rows.push_back(
            {"outside the secondary at " + std::to_string(int(r)) + "°", "", at(p3, r), at(r3, r)});
    e.rows.push_back({"flux of order 2 over all", "",
                      all_flux(RayDensity::even_in_impact_parameter, 2),
                      all_flux(RayDensity::even_over_disc, 2)});
    e.x_label = "angle from the antisolar point (deg)";
    e.y_label = "brightness over the primary's peak", e.logarithmic = true;
    e.curves = {curve_of("as published", sum(p2, p3), 0.0, 120.0, true),
                curve_of("right", sum(r2, r3), 0.0, 120.0, false)};
    return e;
}

}  // namespace dewbow::errata
