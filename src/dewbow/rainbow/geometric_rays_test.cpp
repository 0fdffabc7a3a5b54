// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/geometric_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

Angle angle_of(double b, RelativeIndex n, int p) {
    return scattering_angle(deviation(drop_ray(b, n), p));
}

TEST(GeometricRays, LeaveAtTheAngleAskedFor) {
    /// Rounding of the deflection, some 20 rad, and of asin(b) near the edge.
    constexpr double kRounding = 1e-12;
    for (double n : {1.05, 1.333, 1.5, 1.9})
        for (int p = 0; p <= kHighestOrder; ++p)
            for (double theta = 0.37; theta < 180.0; theta += 0.93)
                for (const GeometricRay& ray : geometric_rays({n}, p, theta * deg)) {
                    EXPECT_NEAR(scattering_angle(deviation(ray.ray, p)).to(rad),
                                (theta * deg).to(rad), kRounding)
                        << n << " " << p << " " << theta;
                    EXPECT_NEAR(n * sin(ray.ray.refraction), ray.impact_parameter, kRounding);
                }
}

TEST(GeometricRays, AreAsManyAsAScanOverTheDropFinds) {
    constexpr int kSteps = 4000;
    const RelativeIndex n{1.333};
    for (int p = 0; p <= kHighestOrder; ++p)
        for (double theta = 0.5; theta < 180.0; theta += 1.0) {
            std::vector<double> found;
            double before = (angle_of(0.0, n, p) - theta * deg).to(deg);
            for (int k = 1; k <= kSteps; ++k) {
                const double b = double(k) / kSteps;
                const double here = (angle_of(b, n, p) - theta * deg).to(deg);
                if ((here > 0.0) != (before > 0.0)) found.push_back(b);
                before = here;
            }
            const auto rays = geometric_rays(n, p, theta * deg);
            ASSERT_EQ(rays.size(), found.size()) << "order " << p << " at " << theta;
            for (std::size_t k = 0; k < rays.size(); ++k)
                EXPECT_NEAR(rays[k].impact_parameter, found[k], 1.0 / kSteps);
        }
}

TEST(GeometricRays, BrightnessFollowsFromNeighbouringRays) {
    // ε² b db / (sin θ dθ) by differences instead of derivatives.
    constexpr double kStep = 1e-6;
    /// kStep² times third derivatives, and 1e-16 / kStep of rounding.
    constexpr double kDifferences = 1e-6;
    const RelativeIndex n{1.333};
    for (int p : {1, 2, 3, 5, 7})
        for (double theta : {12.5, 77.7, 120.1, 150.0, 171.0})
            for (const GeometricRay& ray : geometric_rays(n, p, theta * deg)) {
                const double b = ray.impact_parameter;
                if (b > 0.99) continue;
                const double slope =
                    std::abs((angle_of(b + kStep, n, p) - angle_of(b - kStep, n, p)).to(rad)) /
                    (2.0 * kStep);
                const RayAmplitudes e = ray_amplitudes(drop_ray(b, n), n, p);
                const double expected = b / (std::sin((theta * deg).to(rad)) * slope);
                EXPECT_NEAR(ray.slope / slope, 1.0, kDifferences);
                EXPECT_NEAR(
                    ray.intensity.perpendicular / (e.perpendicular * e.perpendicular * expected),
                    1.0, kDifferences);
                EXPECT_NEAR(ray.intensity.parallel / (e.parallel * e.parallel * expected), 1.0,
                            kDifferences);
            }
}

TEST(GeometricRays, HaveLimitsAtTheAxisAndTheEdge) {
    constexpr double kRounding = 1e-12;
    const double n = 1.333, r0 = (n - 1.0) / (n + 1.0), t0 = 1.0 - r0 * r0;
    // Straight back and straight through: |S|²/x² = ε² / (dD/db)² on the axis.
    EXPECT_NEAR(geometric_intensity({n}, 2, 180.0 * deg).perpendicular,
                std::pow(t0 * r0 / (2.0 - 4.0 / n), 2), kRounding);
    EXPECT_NEAR(geometric_intensity({n}, 1, Angle{}).parallel, std::pow(t0 / (2.0 - 2.0 / n), 2),
                kRounding);
    // Reflection outside is even but for Fresnel, and whole at grazing incidence.
    EXPECT_NEAR(geometric_intensity({n}, 0, 180.0 * deg).perpendicular, 0.25 * r0 * r0, kRounding);
    EXPECT_NEAR(geometric_intensity({n}, 0, Angle{}).perpendicular, 0.25, kRounding);
    // The ray at the critical angle has lost everything.
    const Angle last = 180.0 * deg - 2.0 * std::asin(1.0 / n) * rad;
    EXPECT_NEAR(geometric_intensity({n}, 1, last - 1e-9 * rad).perpendicular, 0.0, 1e-6);
}

TEST(GeometricRays, AreTwoAtTheBowAndNoneBeside) {
    const DescartesRay bow = descartes_ray({1.333}, 2);
    const Angle little = 1e-9 * rad;
    EXPECT_EQ(geometric_rays({1.333}, 2, bow.scattering_angle + little).size(), 2u);
    EXPECT_TRUE(geometric_rays({1.333}, 2, bow.scattering_angle - little).empty());
    // b moves by √(δ / h) to both sides.
    const auto rays = geometric_rays({1.333}, 2, bow.scattering_angle + little);
    const double expected = std::sqrt(1e-9 / bow.airy_constant);
    EXPECT_NEAR((rays[1].impact_parameter - bow.impact_parameter) / expected, 1.0, 1e-3);
    EXPECT_NEAR((bow.impact_parameter - rays[0].impact_parameter) / expected, 1.0, 1e-3);
}

TEST(GeometricRays, RefusesWhatHasNoRays) {
    EXPECT_THROW(ray_branches({1.0}, 1), InputError);
    EXPECT_THROW(ray_branches({0.9}, 0), InputError);
    EXPECT_THROW(ray_branches({1.333}, -1), InputError);
    EXPECT_THROW(ray_branches({2.4}, 2), InputError);
    EXPECT_NO_THROW(ray_branches({2.4}, 3));
}

}  // namespace
}  // namespace dewbow
