// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_ray.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

using namespace unit;
/// Closed forms against closed forms: rounding, with a reserve.
constexpr double kRounding = 1e-12;

TEST(DescartesRay, PrimaryAndSecondaryHaveClosedForms) {
    // D2 = 2 arccos(((4−n²)/3)^{3/2} / n²); D3 = 2 arccos(−(n⁴+18n²−27)/(8n³)): derived without the
    // angle of refraction.
    for (double n = 1.30; n < 1.365; n += 0.01) {
        const double D2 = 2.0 * std::acos(std::pow((4.0 - n * n) / 3.0, 1.5) / (n * n));
        const double D3 =
            2.0 * std::acos(-(std::pow(n, 4) + 18.0 * n * n - 27.0) / (8.0 * n * n * n));
        EXPECT_NEAR(descartes_ray({n}, 2).deviation.to(rad), D2, kRounding);
        EXPECT_NEAR(descartes_ray({n}, 3).deviation.to(rad), D3, kRounding);
    }
}

TEST(DescartesRay, DeviationIsLeastThere) {
    // The slope is zero, and second differences give the curvature 2h.
    constexpr double kStep = 1e-4;
    /// What the fourth derivative adds, step² D⁗ / (12 D″), and 1e-16 / step² of rounding.
    constexpr double kFourthDerivative = 1e-4;
    for (int p = 2; p <= 7; ++p) {
        const RelativeIndex n{1.333};
        const DescartesRay bow = descartes_ray(n, p);
        const auto D = [&](double b) { return deviation(drop_ray(b, n), p).to(rad); };
        const double b = bow.impact_parameter;
        const double curvature = (D(b - kStep) - 2.0 * D(b) + D(b + kStep)) / (kStep * kStep);
        EXPECT_NEAR(deviation_slope(bow.ray, n, p), 0.0, p * p * kRounding);
        EXPECT_NEAR(curvature / (2.0 * bow.airy_constant), 1.0, kFourthDerivative);
    }
}

TEST(DescartesRay, SidesOfTheBows) {
    // The primary is bright inside, at larger scattering angles; the secondary outside.
    //                                                           [van de Hulst 1957, §13.2]
    constexpr double kPrinted = 0.0005;
    const struct {
        int p, side;
        double angle_deg;
    } rows[] = {
        {2, 1, 137.922}, {3, -1, 129.109}, {4, -1, 41.737}, {5, 1, 43.703}, {6, 1, 128.229}};
    for (const auto& row : rows) {
        const DescartesRay bow = descartes_ray({1.333}, row.p);
        EXPECT_EQ(bow.bright_side, row.side) << row.p;
        EXPECT_NEAR(bow.scattering_angle.to(deg), row.angle_deg, kPrinted);
        const DropRay beside = drop_ray(bow.impact_parameter - 0.01, {1.333});
        const Angle theta = scattering_angle(deviation(beside, row.p));
        EXPECT_GT(row.side * (theta - bow.scattering_angle).to(deg), 0.0);
    }
}

TEST(DescartesRay, FresnelIsIndependentOfTheIndex) {
    // |r_s| = (p−1)/(p+1) and |r_p| = |n²−p|/(n²+p) at the Descartes ray.
    for (double n : {1.30, 1.333, 1.36})
        for (int p = 2; p <= 7; ++p) {
            const RayAmplitudes r = ray_amplitudes(descartes_ray({n}, p).ray, {n}, 0);
            EXPECT_NEAR(std::abs(r.perpendicular), (p - 1.0) / (p + 1.0), kRounding);
            EXPECT_NEAR(std::abs(r.parallel), std::abs(n * n - p) / (n * n + p), kRounding);
        }
}

TEST(DescartesRay, RefusesWhatHasNoBow) {
    EXPECT_THROW(descartes_ray({2.5}, 2), InputError);
    EXPECT_THROW(descartes_ray({1.0}, 2), InputError);
    EXPECT_THROW(descartes_ray({1.333}, 1), InputError);
}

TEST(RayAmplitudes, AllOrdersTogetherKeepTheEnergy) {
    // r² + Σ_p (1−r²)² r^{2(p−1)} = 1.
    constexpr double kBeyondOrder40 = 1e-12;
    for (double b : {0.0, 0.3, 0.6, 0.8}) {
        const DropRay ray = drop_ray(b, {1.333});
        double s = 0.0, p = 0.0;
        for (int order = 0; order < 40; ++order) {
            const RayAmplitudes a = ray_amplitudes(ray, {1.333}, order);
            s += a.perpendicular * a.perpendicular;
            p += a.parallel * a.parallel;
        }
        EXPECT_NEAR(s, 1.0, kBeyondOrder40);
        EXPECT_NEAR(p, 1.0, kBeyondOrder40);
    }
}

TEST(ScatteringAngle, Folds) {
    EXPECT_NEAR(scattering_angle(230.0 * deg).to(deg), 130.0, kRounding);
    EXPECT_NEAR(scattering_angle(-170.0 * deg).to(deg), 170.0, kRounding);
    EXPECT_NEAR(scattering_angle(400.0 * deg).to(deg), 40.0, kRounding);
}

TEST(DescartesRay, OfSeaSprayMakesASmallerBow) {
    // Photographs and the optics of rain and spray side by side give about 0.8° for the primary; by
    // 145° per unit of n the salt's 0.0064 makes 0.9°.                [www.atoptics.co.uk, sea
    // spray bows]
    const auto radius = [](const char* water, int p) {
        const Wavelength lambda = 589.3 * nm;
        const AbsoluteIndex n = (*make_dispersion(find_glass(water).data))(lambda);
        return descartes_ray(n / (*air())(lambda), p).radius().to(deg);
    };
    EXPECT_NEAR(radius("water@20C", 2) - radius("sea-water@20C,35", 2), 0.92, 0.01);
    // The secondary grows by 262° per unit.
    EXPECT_NEAR(radius("sea-water@20C,35", 3) - radius("water@20C", 3), 1.66, 0.02);
}

}  // namespace
}  // namespace dewbow
