// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/stokes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-14;

Intensities bow_by_rays(int p) {
    const RelativeIndex n{1.333};
    const RayAmplitudes a = ray_amplitudes(descartes_ray(n, p).ray, n, p);
    return {a.perpendicular * a.perpendicular, a.parallel * a.parallel};
}

TEST(DegreeOfPolarisation, IsNotTheShareOfTheStrongerPart) {
    // Closed forms at the Descartes ray, n = 1.333: r_s = (p−1)/(p+1), r_p = (n²−p)/(n²+p).
    EXPECT_NEAR(degree_of_polarisation(bow_by_rays(2)), 0.92405, 5e-6);
    EXPECT_NEAR(perpendicular_share(bow_by_rays(2)), 0.96203, 5e-6);
    EXPECT_NEAR(degree_of_polarisation(bow_by_rays(3)), 0.80709, 5e-6);
    EXPECT_NEAR(perpendicular_share(bow_by_rays(3)), 0.90354, 5e-6);
    EXPECT_EQ(degree_of_polarisation(Intensities{}), 0.0);
    EXPECT_EQ(degree_of_polarisation(Stokes{}), 0.0);
    EXPECT_EQ(perpendicular_share({}), 0.5);
    EXPECT_EQ(degree_of_polarisation(Intensities{0.0, 2.0}), -1.0);
    for (const double turn : {0.0, 10.0, 70.0, 135.0})
        EXPECT_NEAR(degree_of_polarisation(stokes_of({3.0, 1.0}, turn * deg)), 0.5, kRounding);
}

TEST(ThroughPolariser, IsTheMeanOverFieldsOfSunlight) {
    // Waves of many planes of oscillation, each scattered by amplitudes √I and projected on the
    // axis.
    const Intensities scattered{3.0, 0.7};
    for (const double tangent : {0.0, 25.0, 90.0, -40.0})
        for (const double axis : {0.0, 30.0, 65.0, 90.0, 140.0}) {
            constexpr int kWaves = 360;
            double sum = 0.0;
            for (int k = 0; k < kWaves; ++k) {
                const double plane = kPi * k / kWaves;  // of the field, against the tangent
                const double e_perpendicular = std::sqrt(3.0) * std::cos(plane),
                             e_parallel = std::sqrt(0.7) * std::sin(plane);
                const double turn = (axis - tangent) * kPi / 180.0;
                const double e = e_perpendicular * std::cos(turn) + e_parallel * std::sin(turn);
                sum += e * e / kWaves;
            }
            EXPECT_NEAR(through_polariser(stokes_of(scattered, tangent * deg), axis * deg), sum,
                        1e-13);
        }
}

TEST(ThroughPolariser, LetsThroughWhatTheCrossedOneStops) {
    const Stokes light = stokes_of({2.0, 0.5}, 33.0 * deg);
    for (double axis = 0.0; axis < 180.0; axis += 15.0)
        EXPECT_NEAR(
            through_polariser(light, axis * deg) + through_polariser(light, (axis + 90.0) * deg),
            light.i, kRounding);
    EXPECT_NEAR(through_polariser(light, 33.0 * deg), 0.5 * 2.0, kRounding);
    EXPECT_NEAR(through_polariser(light, 123.0 * deg), 0.5 * 0.5, kRounding);
}

Dir<World> towards(double azimuth_deg, double altitude_deg) {
    const double a = azimuth_deg * kPi / 180.0, h = altitude_deg * kPi / 180.0;
    // Azimuth from −z to the right.
    return {{std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)}};
}

TEST(TangentOfBow, LiesAlongTheArc) {
    // The sun behind, on the horizon; the arc in front.
    const Dir<World> sun = towards(180.0, 0.0);
    EXPECT_NEAR(std::abs(tangent_of_bow(towards(0.0, 42.0), sun).to(deg)), 90.0, 1e-9);
    EXPECT_NEAR(tangent_of_bow(towards(42.0, 0.0), sun).to(deg), 0.0, 1e-9);
    EXPECT_NEAR(tangent_of_bow(towards(-42.0, 0.0), sun).to(deg), 0.0, 1e-9);
    // On the right the arc leans to the left as it rises: counterclockwise.
    EXPECT_GT(tangent_of_bow(towards(30.0, 30.0), sun).to(deg), 20.0);
    EXPECT_LT(tangent_of_bow(towards(-30.0, 30.0), sun).to(deg), -20.0);
    EXPECT_EQ(tangent_of_bow(towards(0.0, 0.0), sun).to(deg), 0.0);
}

TEST(TangentOfBow, IsTheDifferenceOfTwoPointsOfTheArc) {
    // The circle of 42° around the antisolar point of a sun at 20°, point by point.
    const Dir<World> sun = towards(180.0, 20.0);
    const Vec3 axis = -sun.v, up = normalised(Vec3{0, 1, 0} - axis.y * axis),
               right = cross(axis, up);
    const auto point = [&](double clock) {
        const double rho = 42.0 * kPi / 180.0;
        return std::cos(rho) * axis +
               std::sin(rho) * (std::cos(clock) * up + std::sin(clock) * right);
    };
    for (double clock = 0.1; clock < 6.2; clock += 0.3) {
        const Vec3 view = point(clock), step = point(clock + 1e-6) - point(clock - 1e-6);
        const Vec3 vertical = normalised(Vec3{0, 1, 0} - view.y * view);
        const Vec3 left = cross(vertical, view);
        const double expected = std::atan(dot(step, left) / dot(step, vertical)) * 180.0 / kPi;
        EXPECT_NEAR(std::remainder(tangent_of_bow({view}, sun).to(deg) - expected, 180.0), 0.0,
                    1e-6)
            << clock;
    }
}

}  // namespace
}  // namespace dewbow
