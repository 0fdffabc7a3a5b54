// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/airy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/math/airy.h"
#include "dewbow/rainbow/debye.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/uniform_airy.h"

namespace dewbow {
namespace {

using namespace unit;

ModelOptions of_order(int p) {
    ModelOptions options;
    options.orders = {p};
    return options;
}
std::vector<Intensities> intensities_of(const ScatteringModel& model, const Drop& drop,
                                        const std::vector<Angle>& theta, double n = 1.333) {
    std::vector<Intensities> out(theta.size());
    model.intensities({n, 0.0}, {&drop, 1}, theta, out);
    return out;
}

TEST(AiryModel, IsTheClosedForm) {
    // At z = 0: |S_1|² = 2π x^{7/3} b / (sin θ_R h^{2/3}) [ε² Ai(0)² + …], with |r_s| = (p-1)/(p+1)
    // for any index, and dε/db by differences, which are good to 1e-8.
    constexpr double kDifferences = 1e-8, kStep = 1e-5;
    for (double n : {1.31, 1.333, 1.5})
        for (int p : {2, 3, 5}) {
            const DescartesRay bow = descartes_ray({n}, p);
            const double x = 1500.0, b = bow.impact_parameter, h = bow.airy_constant;
            const double r = (p - 1.0) / (p + 1.0), e = (1.0 - r * r) * std::pow(r, p - 1);
            const RayAmplitudes more = ray_amplitudes(drop_ray(b + kStep, {n}), {n}, p);
            const RayAmplitudes less = ray_amplitudes(drop_ray(b - kStep, {n}), {n}, p);
            const double slope = (more.perpendicular - less.perpendicular) / (2.0 * kStep);
            const AiryPair ai = airy(0.0);
            const double expected =
                2.0 * 3.14159265358979324 * std::pow(x, 7.0 / 3.0) * b /
                (sin(bow.scattering_angle) * std::pow(h, 2.0 / 3.0)) *
                (e * e * ai.value * ai.value +
                 slope * slope * std::pow(x * h, -2.0 / 3.0) * ai.derivative * ai.derivative);
            const auto found =
                intensities_of(*make_airy(of_order(p)), {x}, {bow.scattering_angle}, n);
            EXPECT_NEAR(found[0].perpendicular / expected, 1.0, kDifferences) << n << " " << p;
        }
}

TEST(AiryModel, PeaksWhereTheTableSays) {
    // Main maximum and first supernumerary of x = 1000: airy_vs_debye_peaks, n = 1.333.
    constexpr double kPrinted = 0.001;
    const struct {
        int p;
        double main, first;
    } rows[] = {{2, 138.913, 141.083}, {3, 127.339, 123.464}};
    for (const auto& row : rows) {
        const auto model = make_airy(of_order(row.p));
        for (double peak : {row.main, row.first}) {
            const auto i = intensities_of(*model, {1000.0},
                                          {(peak - 0.05) * deg, peak * deg, (peak + 0.05) * deg});
            // The vertex of the parabola through three points.
            const double a = i[0].perpendicular, b = i[1].perpendicular, c = i[2].perpendicular;
            EXPECT_NEAR(0.05 * 0.5 * (a - c) / (a - 2.0 * b + c), 0.0, kPrinted + 0.002) << peak;
        }
    }
}

TEST(AiryModel, ApproachesDebye) {
    // Peak heights of Debye's term over Airy's.                      [reference, n = 1.333]
    constexpr double kPrinted = 0.001;
    const struct {
        int p;
        double x, ratio;
    } rows[] = {{2, 500.0, 0.971}, {2, 1000.0, 0.981}, {2, 2000.0, 0.988}, {3, 1000.0, 0.881}};
    for (const auto& row : rows) {
        const DescartesRay bow = descartes_ray({1.333}, row.p);
        std::vector<Angle> theta;
        for (double u = 0.0; u < 2.0; u += 0.01)
            theta.push_back(bow.scattering_angle +
                            bow.bright_side * u * std::cbrt(bow.airy_constant / (row.x * row.x)) *
                                rad);
        double airy_peak = 0.0, debye_peak = 0.0;
        for (const auto& i : intensities_of(*make_airy(of_order(row.p)), {row.x}, theta))
            airy_peak = std::max(airy_peak, i.perpendicular);
        for (const auto& i : intensities_of(*make_debye(of_order(row.p)), {row.x}, theta))
            debye_peak = std::max(debye_peak, i.perpendicular);
        EXPECT_NEAR(debye_peak / airy_peak, row.ratio, kPrinted) << row.p << " " << row.x;
    }
}

TEST(AiryModel, KnowsThePhaseAtTheBow) {
    // The complex amplitudes of both models meet as x grows: at the Descartes ray they differ by
    // terms in x^{-1/3} of the other Airy function, at x = 20,000 by 0.02 (p = 2) to 0.08 (p = 5).
    constexpr double kNextTerm = 0.1;
    for (int p = 2; p <= 5; ++p) {
        const std::vector<Angle> theta{descartes_ray({1.333}, p).scattering_angle};
        std::vector<Amplitudes> a(1), b(1);
        const auto simple = make_airy(of_order(p)), uniform = make_uniform_airy(of_order(p));
        dynamic_cast<const AmplitudeModel&>(*simple).amplitudes({1.333, 0.0}, {20000.0}, theta, a);
        dynamic_cast<const AmplitudeModel&>(*uniform).amplitudes({1.333, 0.0}, {20000.0}, theta, b);
        EXPECT_LT(std::abs(a[0].perpendicular / b[0].perpendicular - 1.0), kNextTerm) << p;
    }
}

TEST(AiryModel, PathsGrowByTheImpactParameter) {
    // One Airy unit to either side of the bow as well. A path wrong by 1 % of b would turn the
    // phase by 0.4 there.
    constexpr double kCurvature = 0.15;
    const DescartesRay bow = descartes_ray({1.333}, 2);
    const Angle unit_angle = std::cbrt(bow.airy_constant / 4e8) * rad;
    const std::vector<Angle> theta{bow.scattering_angle - unit_angle,
                                   bow.scattering_angle + unit_angle};
    std::vector<Amplitudes> a(2), b(2);
    const auto simple = make_airy(of_order(2)), uniform = make_uniform_airy(of_order(2));
    dynamic_cast<const AmplitudeModel&>(*simple).amplitudes({1.333, 0.0}, {20000.0}, theta, a);
    dynamic_cast<const AmplitudeModel&>(*uniform).amplitudes({1.333, 0.0}, {20000.0}, theta, b);
    for (int k : {0, 1})
        EXPECT_NEAR(std::arg(a[k].perpendicular / b[k].perpendicular), 0.0, kCurvature) << k;
}

TEST(AiryModel, TurnsWithTheDropsShape) {
    // By 2°, and spread over as much more solid angle as there is.
    constexpr double kRounding = 1e-12;
    Drop flat{2000.0};
    flat.shifts[2] = 2.0 * deg;
    const auto model = make_airy(of_order(2));
    const auto turned = intensities_of(*model, flat, {141.0 * deg});
    const auto round = intensities_of(*model, {2000.0}, {139.0 * deg});
    EXPECT_NEAR(turned[0].perpendicular / round[0].perpendicular,
                sin(139.0 * deg) / sin(141.0 * deg), kRounding);
}

TEST(AiryModel, IsNotANumberWhereItDoesNotHold) {
    // Beyond the grazing rays of p = 2 (165.6°) and p = 3 (111.6°).
    const auto i =
        intensities_of(*make_airy({}), {1000.0}, {111.0 * deg, 112.0 * deg, 166.0 * deg});
    EXPECT_TRUE(std::isnan(i[0].perpendicular));
    EXPECT_TRUE(std::isfinite(i[1].perpendicular));
    EXPECT_TRUE(std::isnan(i[2].parallel));
}

TEST(AiryModel, RefusesWhatItCannotTreat) {
    EXPECT_THROW(make_airy(of_order(0)), InputError);
    const auto model = make_airy(of_order(2));
    EXPECT_THROW(intensities_of(*model, {1000.0}, {2.4 * rad}, 2.5), InputError);
    EXPECT_THROW(intensities_of(*model, {0.0}, {2.4 * rad}), InputError);
    EXPECT_THROW(model->efficiencies({1.333, 0.1}, {1000.0}), InputError);
}

}  // namespace
}  // namespace dewbow
