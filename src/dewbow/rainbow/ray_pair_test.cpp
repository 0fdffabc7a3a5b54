// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/ray_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/geometric_rays.h"
#include "dewbow/rainbow/ray_pair_series.h"

namespace dewbow {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(BowGeometry, EndsAreThoseOfTheRays) {
    const BowGeometry bow = bow_geometry({1.333}, 3);
    EXPECT_DOUBLE_EQ(bow.grazing(), deviation(drop_ray(1.0, {1.333}), 3).to(unit::rad));
    EXPECT_DOUBLE_EQ(bow.most, deviation(drop_ray(0.0, {1.333}), 3).to(unit::rad));
    EXPECT_THROW(bow_geometry({1.333}, 1), InputError);
}

TEST(RayPair, AtTheBowItIsTheDescartesRay) {
    // ζ and P have closed forms there: ζ = 0 with slope h^{-1/3}, P = √b ε h^{-1/3}.
    constexpr double kRounding = 1e-10, kStep = 1e-4, kSecondOrder = 1e-4;
    for (double n : {1.30, 1.333, 1.36})
        for (int p = kLowestBow; p <= kHighestBow; ++p) {
            const BowGeometry bow = bow_geometry({n}, p);
            const RayPair<double> pair = ray_pair(bow, 0.0);
            const DescartesRay ray = descartes_ray({n}, p);
            const RayAmplitudes left = ray_amplitudes(ray.ray, {n}, p);
            const double per_root_h = 1.0 / std::cbrt(bow.curvature);
            const double scale = std::sqrt(ray.impact_parameter) * per_root_h;
            EXPECT_NEAR(pair.zeta, 0.0, kRounding);
            EXPECT_NEAR(pair.perpendicular.P, left.perpendicular * scale, kRounding);
            EXPECT_NEAR(pair.parallel.P, left.parallel * scale, kRounding);
            const double slope =
                (ray_pair(bow, kStep).zeta - ray_pair(bow, -kStep).zeta) / (2.0 * kStep);
            EXPECT_NEAR(slope / per_root_h, 1.0, kSecondOrder);
        }
}

TEST(RayPair, MeanOverACircleIsTheDirectAnswer) {
    // At 1/20 of the span both ways work, and the direct one still has all but five digits in the
    // functions that take the most differences.
    constexpr double kLeading = 1e-10, kNext = 1e-6;
    for (int p = kLowestBow; p <= kHighestBow; ++p) {
        const BowGeometry bow = bow_geometry({1.333}, p);
        for (double offset : {-0.05 * bow.span, 0.05 * bow.span}) {
            RayPair<double> mean = ray_pair(bow, offset);
            RayPair<std::complex<double>> direct = separate_rays(bow, offset);
            for (std::size_t f = 0; f < mean.list().size(); ++f) {
                const double found = *mean.list()[f], exact = direct.list()[f]->real();
                bool is_next = false;
                for (double* next : mean.singular()) is_next |= next == mean.list()[f];
                EXPECT_NEAR(found / exact, 1.0, is_next ? kNext : kLeading) << p << " " << f;
                EXPECT_NEAR(direct.list()[f]->imag() / exact, 0.0, kNext) << p << " " << f;
            }
        }
    }
}

TEST(RayPair, InsideItIsTwoGeometricRays) {
    // G(±a) = P ± a Q is what a single ray has: its |S|²/x² = ε² b / (sin θ dD/db) is G² / (2a)
    // over sin θ. Against the rays found by scattering angle.
    constexpr double kRounding = 1e-9;
    const BowGeometry bow = bow_geometry({1.333}, 2);
    for (double part : {0.02, 0.3, 0.9}) {
        const double offset = part * bow.span, theta = bow.least + offset;
        const RayPair<double> pair = ray_pair(bow, offset);
        const auto rays = geometric_rays({1.333}, 2, theta * unit::rad);
        ASSERT_EQ(rays.size(), 2u);
        const double a = std::sqrt(pair.zeta);
        for (int k : {0, 1}) {
            const double sign = k == 0 ? -1.0 : 1.0;
            const double s = pair.perpendicular.P + sign * a * pair.perpendicular.Q;
            const double q = pair.parallel.P + sign * a * pair.parallel.Q;
            const double scale = 1.0 / (2.0 * a * std::sin(theta));
            EXPECT_NEAR(s * s * scale / rays[k].intensity.perpendicular, 1.0, kRounding);
            EXPECT_NEAR(q * q * scale / rays[k].intensity.parallel, 1.0, kRounding);
        }
    }
}

TEST(LoneRay, IsAGeometricRay) {
    // |S|²/x² = ε² b / (sin θ |dD/db|), against the rays found by scattering angle; p = 3 between
    // the grazing ray at 111.6° and the central one at 0°.
    constexpr double kRounding = 1e-9;
    const BowGeometry bow = bow_geometry({1.333}, 3);
    for (double theta : {1e-3, 0.5, 1.0, 1.9}) {
        const auto rays = geometric_rays({1.333}, 3, theta * unit::rad);
        ASSERT_EQ(rays.size(), 1u);
        const LoneRay ray = lone_ray(bow, 2.0 * kPi - theta - bow.least);
        const double focus = theta / std::sin(theta);
        EXPECT_NEAR(ray.perpendicular * ray.perpendicular * focus / rays[0].intensity.perpendicular,
                    1.0, kRounding)
            << theta;
        EXPECT_NEAR(ray.parallel * ray.parallel * focus / rays[0].intensity.parallel, 1.0,
                    kRounding)
            << theta;
    }
    // On the axis itself it is 1 / |dD/db|².
    const double slope = 2.0 - 2.0 * 3.0 / 1.333;
    const double left = ray_amplitudes(drop_ray(0.0, {1.333}), {1.333}, 3).perpendicular;
    EXPECT_NEAR(lone_ray(bow, bow.most - bow.least).perpendicular, left / std::abs(slope),
                kRounding);
}

TEST(LoneRay, GoesOnFromThePairWithoutASeam) {
    // Where the second ray ends P = -√ζ Q; beside the end, within the step.
    constexpr double kStep = 1e-8, kOfStep = 1e-6;
    for (int p = kLowestBow; p <= kHighestBow; ++p) {
        const BowGeometry bow = bow_geometry({1.333}, p);
        const RayPair<double> pair = ray_pair(bow, bow.span - kStep);
        RayPair<double> lone = lone_pair(bow, bow.span, lone_ray(bow, bow.span));
        const double scale = std::sqrt(bow.most - bow.grazing());
        EXPECT_NEAR(lone.zeta, pair.zeta, kOfStep);
        EXPECT_NEAR(lone.path, pair.path, kOfStep);
        EXPECT_NEAR(lone.perpendicular.P * scale, pair.perpendicular.P, kOfStep) << p;
        EXPECT_NEAR(lone.perpendicular.Q * scale / pair.perpendicular.Q, 1.0, kOfStep) << p;
        EXPECT_NEAR(lone.parallel.P * scale, pair.parallel.P, kOfStep) << p;
        EXPECT_NEAR(lone.parallel.Q * scale / pair.parallel.Q, 1.0, kOfStep) << p;
    }
}

TEST(RayPairSeries, InterpolatesWithinItsError) {
    // Of each function's largest value between the bow and 4 spans into the dark; P_next and Q_next
    // times what makes them finite.
    constexpr double kStated = 1e-7;
    for (int p = kLowestBow; p <= kHighestBow; ++p)
        for (double n : {1.3, 1.3117, 1.333, 1.3481, 1.36}) {
            const RayPairSeries series({n}, p);
            const BowGeometry& bow = series.geometry();
            std::array<double, RayPair<double>::kCount> worst{}, largest{};
            for (double sigma = 0.02; sigma < 2.2; sigma += 0.0937) {
                const double D = bow.grazing() - bow.span * sigma * sigma;
                RayPair<double> found = series.at(D), exact = ray_pair(bow, D - bow.least);
                for (RayPair<double>* pair : {&found, &exact})
                    for (double* next : pair->singular()) *next *= sigma * sigma * sigma;
                for (std::size_t f = 0; f < worst.size(); ++f) {
                    const double value = *exact.list()[f];
                    worst[f] = std::max(worst[f], std::abs(*found.list()[f] - value));
                    largest[f] = std::max(largest[f], std::abs(value));
                }
            }
            for (std::size_t f = 0; f < worst.size(); ++f)
                EXPECT_LT(worst[f], kStated * largest[f]) << n << " " << p << " " << f;
        }
}

TEST(RayPairSeries, InterpolatesLoneRays) {
    // Amplitudes relative to the largest of each; paths absolute, as phases need them.
    constexpr double kAmplitude = 1e-6, kPath = 1e-10;
    for (int p = kLowestBow; p <= kHighestBow; ++p)
        for (double n : {1.3, 1.333, 1.3481}) {
            const RayPairSeries series({n}, p);
            const BowGeometry& bow = series.geometry();
            const LoneRay strongest = lone_ray(bow, bow.span);
            for (double part = 0.0; part <= 1.0; part += 0.0625) {
                const double D = bow.grazing() + part * (bow.most - bow.grazing());
                const RayPair<double> exact =
                    lone_pair(bow, D - bow.least, lone_ray(bow, D - bow.least));
                const RayPair<double> found = series.at(D);
                EXPECT_NEAR(found.path, exact.path, kPath) << n << " " << p;
                EXPECT_NEAR(found.zeta, exact.zeta, kPath) << n << " " << p;
                EXPECT_NEAR(found.perpendicular.P, exact.perpendicular.P,
                            kAmplitude * std::abs(strongest.perpendicular))
                    << n << " " << p;
                EXPECT_NEAR(found.parallel.Q, exact.parallel.Q,
                            kAmplitude * std::abs(strongest.perpendicular))
                    << n << " " << p;
            }
        }
}

TEST(RayPairSeries, RefusesWhatItDoesNotCover) {
    EXPECT_THROW(RayPairSeries({1.29}, 2), InputError);
    EXPECT_THROW(RayPairSeries({1.37}, 2), InputError);
    EXPECT_THROW(RayPairSeries({std::nan("")}, 2), InputError);
    EXPECT_THROW(RayPairSeries({1.333}, 1), InputError);
    EXPECT_THROW(RayPairSeries({1.333}, 8), InputError);
    EXPECT_GT(RayPairSeries({1.333}, 2).darkest(), -kPi);
}

}  // namespace
}  // namespace dewbow
