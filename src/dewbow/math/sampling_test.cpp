// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
// Roundings of a sum of thousands of terms of size 1.
constexpr double kRounding = 1e-13;
// Maps with creases (disc, triangle) are integrated in the pieces between them, where they are
// smooth; 40 nodes leave less than rounding.
constexpr int kNodes = 40;
// Gauss's rule converges slowly where the map has a square root's end (sin theta at the axis, cos
// theta at the horizon): at most 5e-6 for its odd powers.
constexpr double kRootError = 1e-5;
constexpr double kOneBelow = 1.0 - 0x1p-53;
constexpr std::array<double, 6> kExtremes{0.0, 0x1p-53, 0x1p-32, 0.5, 1.0 - 0x1p-32, kOneBelow};

using Function = std::function<double(double, double)>;

/// Integral over the square, each of the four triangles between its diagonals by itself.
double integral_over_square(const Function& f) {
    static const QuadratureRule rule = gauss_legendre(kNodes);
    double sum = 0.0;
    for (const double sign : {-1.0, 1.0})
        for (const bool wide : {false, true})
            sum += integrate(rule, 0.0, 1.0, [&](double r) {
                return integrate(rule, -1.0, 1.0, [&](double s) {
                    const double a = 0.5 + 0.5 * sign * r, b = 0.5 + 0.5 * s * r;
                    return 0.25 * r * (wide ? f(a, b) : f(b, a));
                });
            });
    return sum;
}

/// Mean of x^i y^j z^k over the directions that `sample` gives.
template <class Sample>
double moment(const Sample& sample, int i, int j, int k) {
    return integral_over_square([&](double u0, double u1) {
        const Vec3 v = sample(u0, u1).v;
        return std::pow(v.x, i) * std::pow(v.y, j) * std::pow(v.z, k);
    });
}

TEST(IntegralOverSquare, IntegratesWhatItShould) {
    EXPECT_NEAR(integral_over_square([](double, double) { return 1.0; }), 1.0, kRounding);
    EXPECT_NEAR(integral_over_square([](double x, double y) { return x * x * y; }), 1.0 / 6.0,
                kRounding);
    EXPECT_NEAR(integral_over_square([](double x, double y) { return std::abs(x - y); }), 1.0 / 3.0,
                kRounding);
}

TEST(UniformSphere, Moments) {
    const auto sample = sample_uniform_sphere<World>;
    EXPECT_NEAR(moment(sample, 1, 0, 0), 0.0, kRootError);
    EXPECT_NEAR(moment(sample, 0, 1, 0), 0.0, kRootError);
    EXPECT_NEAR(moment(sample, 0, 0, 1), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 0, 0), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 2, 0), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 2), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 1, 1, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 4), 1.0 / 5.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 2, 0), 1.0 / 15.0, kRounding);
    EXPECT_DOUBLE_EQ(pdf_uniform_sphere() * 4.0 * kPi, 1.0);
}

TEST(UniformCone, Moments) {
    for (const double alpha : {0.3, 1.0, kPi / 2.0, 3.0, kPi}) {
        const double width = one_minus_cos(alpha * unit::rad), c = std::cos(alpha);
        const auto sample = [&](double u0, double u1) {
            return sample_uniform_cone(width, u0, u1);
        };
        EXPECT_NEAR(moment(sample, 1, 0, 0), 0.0, kRootError);
        EXPECT_NEAR(moment(sample, 0, 0, 1), (1.0 + c) / 2.0, kRounding);
        EXPECT_NEAR(moment(sample, 0, 0, 2), (1.0 + c + c * c) / 3.0, kRounding);
        EXPECT_NEAR(moment(sample, 2, 0, 0), (1.0 - (1.0 + c + c * c) / 3.0) / 2.0, kRounding);
        EXPECT_NEAR(pdf_uniform_cone(width) * 2.0 * kPi * (1.0 - c), 1.0, kRounding);
    }
}

TEST(UniformCone, TinyConesKeepTheirShape) {
    for (const double alpha : {1e-2, 1e-4, 1e-8, 1e-12, 1e-150}) {
        const double width = one_minus_cos(alpha * unit::rad);
        // 1 - cos(alpha) = alpha²/2 - alpha⁴/24 + …
        EXPECT_NEAR(width / (0.5 * alpha * alpha * (1.0 - alpha * alpha / 12.0)), 1.0,
                    kRounding + std::pow(alpha, 4));
        for (const double u0 : {0.01, 0.25, 0.7, kOneBelow}) {
            const Vec3 v = sample_uniform_cone(width, u0, 0.3).v;
            const double theta = std::atan2(std::hypot(v.x, v.y), v.z);
            // Solid angle within theta over that of the cone: sin²(theta/2) / sin²(alpha/2) = u0.
            const double ratio = std::sin(theta / 2.0) / std::sin(alpha / 2.0);
            EXPECT_NEAR(ratio * ratio, u0, kRounding) << alpha;
            EXPECT_NEAR(std::atan2(v.y, v.x), 0.6 * kPi, kRounding);
        }
    }
}

TEST(ConcentricDisc, Moments) {
    const auto sample = [](double u0, double u1) {
        const DiscPoint p = sample_concentric_disc(u0, u1);
        return Dir<Local>{{p.x, p.y, 0.0}};
    };
    EXPECT_NEAR(moment(sample, 1, 0, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 1, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 0, 0), 1.0 / 4.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 2, 0), 1.0 / 4.0, kRounding);
    EXPECT_NEAR(moment(sample, 1, 1, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 4, 0, 0), 1.0 / 8.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 2, 0), 1.0 / 24.0, kRounding);
    EXPECT_DOUBLE_EQ(pdf_concentric_disc() * kPi, 1.0);
}

TEST(ConcentricDisc, CentreCornersAndContinuity) {
    const DiscPoint centre = sample_concentric_disc(0.5, 0.5);
    EXPECT_EQ(centre.x, 0.0);
    EXPECT_EQ(centre.y, 0.0);
    for (const double u0 : kExtremes)
        for (const double u1 : kExtremes) {
            const DiscPoint p = sample_concentric_disc(u0, u1);
            EXPECT_LE(std::hypot(p.x, p.y), 1.0);
            // The quadrant is kept.
            EXPECT_GE(p.x * (u0 - 0.5), -1e-16);
            EXPECT_GE(p.y * (u1 - 0.5), -1e-16);
        }
    // Across the creases.
    for (const double u : {0.01, 0.3, 0.8}) {
        const DiscPoint a = sample_concentric_disc(u, u + 1e-12);
        const DiscPoint b = sample_concentric_disc(u + 1e-12, u);
        EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 1e-11);
    }
}

TEST(CosineHemisphere, Moments) {
    const auto sample = sample_cosine_hemisphere;
    EXPECT_NEAR(moment(sample, 1, 0, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 1, 0), 0.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 1), 2.0 / 3.0, kRootError);
    EXPECT_NEAR(moment(sample, 0, 0, 2), 1.0 / 2.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 0, 0), 1.0 / 4.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 4), 1.0 / 3.0, kRounding);
    // The density integrates to 1: 2 pi times the integral of cosine over the cosine.
    const QuadratureRule rule = gauss_legendre(2);
    EXPECT_NEAR(2.0 * kPi * integrate(rule, 0.0, 1.0, pdf_cosine_hemisphere), 1.0, kRounding);
    EXPECT_EQ(pdf_cosine_hemisphere(-0.5), 0.0);
}

TEST(CosineHemisphere, AlwaysAboveTheHorizon) {
    for (const double u0 : kExtremes)
        for (const double u1 : kExtremes) {
            const Vec3 v = sample_cosine_hemisphere(u0, u1).v;
            EXPECT_GT(v.z, 0.0);
            EXPECT_NEAR(length(v), 1.0, 4e-16);
        }
}

TEST(CosineHemisphere, HeightAtTheRimIsExact) {
    // r = 1 - 2^-53, so that z = sqrt(1 - r²) = 2^-26; computed from the rounded x and y it would
    // be noise.
    for (int i = 0; i < 1000; ++i)
        ASSERT_DOUBLE_EQ(sample_cosine_hemisphere(0.0, i / 1000.0).v.z, 0x1p-26);
}

TEST(UniformTriangle, Moments) {
    const auto sample = [](double u0, double u1) {
        const Barycentric b = sample_uniform_triangle(u0, u1);
        return Dir<Local>{{b.a, b.b, b.c}};
    };
    // Mean of a^i b^j c^k over a triangle: 2 i! j! k! / (i + j + k + 2)!
    EXPECT_NEAR(moment(sample, 1, 0, 0), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 1, 0), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 1), 1.0 / 3.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 0, 0), 1.0 / 6.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 0, 2), 1.0 / 6.0, kRounding);
    EXPECT_NEAR(moment(sample, 1, 1, 0), 1.0 / 12.0, kRounding);
    EXPECT_NEAR(moment(sample, 0, 1, 1), 1.0 / 12.0, kRounding);
    EXPECT_NEAR(moment(sample, 2, 1, 1), 1.0 / 180.0, kRounding);
    EXPECT_NEAR(moment(sample, 3, 0, 2), 1.0 / 210.0, kRounding);
    EXPECT_DOUBLE_EQ(pdf_uniform_triangle(0.25), 4.0);
}

TEST(UniformTriangle, WeightsAreNeverNegative) {
    for (const double u0 : kExtremes)
        for (const double u1 : kExtremes) {
            const Barycentric b = sample_uniform_triangle(u0, u1);
            EXPECT_GE(b.a, 0.0);
            EXPECT_GE(b.b, 0.0);
            EXPECT_GE(b.c, 0.0);
            EXPECT_NEAR(b.a + b.b + b.c, 1.0, 4e-16);
        }
}

TEST(Around, TurnsTheZAxisToTheGivenOne) {
    const Dir<World> axis{normalised({1, -2, 0.5})};
    EXPECT_LT(length(around(axis, {{0, 0, 1}}).v - axis.v), 1e-16);
    const Dir<World> turned = around(axis, {{0.6, 0.0, 0.8}});
    EXPECT_NEAR(length(turned.v), 1.0, 4e-16);
    EXPECT_NEAR(dot(turned, axis), 0.8, 4e-16);
}

TEST(Sampling, ExtremeNumbersGiveUnitVectors) {
    for (const double u0 : kExtremes)
        for (const double u1 : kExtremes) {
            EXPECT_NEAR(length(sample_uniform_sphere<World>(u0, u1).v), 1.0, 4e-16);
            for (const double width : {1e-300, 1e-16, 1e-8, 1.0, 2.0})
                EXPECT_NEAR(length(sample_uniform_cone(width, u0, u1).v), 1.0, 4e-16);
        }
}

/// Away from creases and poles, where a rounding of the point is a large step in the square.
TEST(Sampling, SquaresAreFoundBack) {
    constexpr int kGrid = 16;
    // 1 − cos of a direction that is kept by its cosine loses as many digits as it is small.
    constexpr double kFoundBack = 1e-12;
    const auto near = [&](std::array<double, 2> back, double u0, double u1) {
        EXPECT_NEAR(back[0], u0, kFoundBack);
        EXPECT_NEAR(back[1], u1, kFoundBack);
    };
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const double u0 = (i / kGrid + 0.4) / kGrid, u1 = (i % kGrid + 0.7) / kGrid;
        near(square_from_uniform_sphere(sample_uniform_sphere<Local>(u0, u1)), u0, u1);
        for (const double width : {1e-10, 0.3, 2.0})
            near(square_from_uniform_cone(width, sample_uniform_cone(width, u0, u1)), u0, u1);
        near(square_from_concentric_disc(sample_concentric_disc(u0, u1)), u0, u1);
        near(square_from_cosine_hemisphere(sample_cosine_hemisphere(u0, u1)), u0, u1);
        near(square_from_uniform_triangle(sample_uniform_triangle(u0, u1)), u0, u1);
    }
    EXPECT_EQ(square_from_concentric_disc({0.0, 0.0}), (std::array{0.5, 0.5}));
}

TEST(Sampling, StandsToTheAxisAsBefore) {
    const Dir<World> axis{normalised(Vec3{0.3, -0.5, -0.8})};
    const Dir<Local> d = sample_uniform_cone(1e-6, 0.3, 0.4);
    const Dir<Local> back = from_axis(axis, around(axis, d));
    EXPECT_NEAR(length(back.v - d.v), 0.0, kRounding);
}

}  // namespace
}  // namespace dewbow
