// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/vector.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kPi = std::numbers::pi;
const RelativeIndex kWater{1.333};

double axis_ratio_of(double e) { return (1.0 - e) / (1.0 + e); }

TEST(RaindropAxisRatio, IsTheFitInCentimetresToo) {
    // 1.0048 + 0.0057 D − 2.628 D² + 3.682 D³ − 1.677 D⁴ with D in cm.
    for (const double d_mm : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
        const double d = 0.1 * d_mm;
        EXPECT_NEAR(raindrop_axis_ratio(0.5 * d_mm * mm),
                    1.0048 + 0.0057 * d - 2.628 * d * d + 3.682 * d * d * d - 1.677 * d * d * d * d,
                    1e-12)
            << d_mm;
    }
    EXPECT_EQ(raindrop_axis_ratio(10.0 * um), 1.0);
    EXPECT_EQ(raindrop_axis_ratio(0.2 * mm), 1.0);
    double before = 1.0;
    for (double d = 0.5; d <= 6.0; d += 0.1) {
        EXPECT_LT(raindrop_axis_ratio(0.5 * d * mm), before);
        before = raindrop_axis_ratio(0.5 * d * mm);
    }
    EXPECT_EQ(raindrop_axis_ratio(5.0 * mm), raindrop_axis_ratio(3.0 * mm));
}

TEST(OblatenessAmplitude, IsMoebiusForThePrimaryAndTheTableForTheOthers) {
    for (const double n : {1.32, 1.333, 1.345}) {
        const Angle r = descartes_ray({n}, 2).ray.refraction;
        EXPECT_NEAR(oblateness_amplitude({n}, 2), -16.0 * sin(r) * std::pow(cos(r), 3), 1e-12);
    }
    // By rays through an ellipse, to 1e-4.
    const double traced[] = {-4.599026, -0.255866, 7.242840, 3.799106, -9.029550, -8.452919};
    for (int p = 2; p <= 7; ++p)
        EXPECT_NEAR(oblateness_amplitude(kWater, p), traced[p - 2], 1e-6) << p;
}

/// A tracer of its own: the quadric x²/A + y²/A + z²/B = 1 by its roots, rays by their offset in
/// space, refraction by Snell's law in the plane of incidence.
struct Tracer {
    double a2, b2;  // squares of the half-axes
    Vec3 gradient(Vec3 x) const { return normalised({x.x / a2, x.y / a2, x.z / b2}); }
    Vec3 meet(Vec3 o, Vec3 d, bool far) const {
        const double a = (d.x * d.x + d.y * d.y) / a2 + d.z * d.z / b2;
        const double b = (o.x * d.x + o.y * d.y) / a2 + o.z * d.z / b2;
        const double c = (o.x * o.x + o.y * o.y) / a2 + o.z * o.z / b2 - 1.0;
        const double root = std::sqrt(b * b - a * c);
        return o + (-b + (far ? root : -root)) / a * d;
    }
    static Vec3 snell(Vec3 d, Vec3 outward, double ratio) {
        const double c = dot(d, outward);
        const Vec3 along = d - c * outward;
        const double sine = length(along) * ratio;
        const Vec3 behind = std::copysign(std::sqrt(1.0 - sine * sine), c) * outward;
        return ratio * along + behind;
    }
    Vec3 leave(Vec3 d, Vec3 offset, double n, int p) const {
        Vec3 x = meet(offset - 9.0 * d, d, false);
        d = snell(d, gradient(x), 1.0 / n);
        for (int j = 1; j < p; ++j) {
            x = meet(x, d, true);
            d = d - 2.0 * dot(d, gradient(x)) * gradient(x);
        }
        return snell(d, gradient(meet(x, d, true)), n);
    }
};

/// The bow's scattering angle by brute force: of all rays near the Descartes ray's place, those
/// that leave towards the clock angle, and the extremum of their angle.
double traced_bow(double e, double altitude, double clock, int p) {
    const DescartesRay bow = descartes_ray(kWater, p);
    const Tracer drop{(1.0 + e) * (1.0 + e), (1.0 - e) * (1.0 - e)};
    const Vec3 d{std::cos(altitude), 0.0, -std::sin(altitude)};
    const Vec3 up{std::sin(altitude), 0.0, std::cos(altitude)}, right{0.0, -1.0, 0.0};
    double extreme = -bow.bright_side * -4.0;
    constexpr int kPlaces = 400, kClocks = 40;
    for (int i = 0; i <= kPlaces; ++i) {
        const double b = bow.impact_parameter + 0.1 * (double(i) / kPlaces - 0.5);
        double angle = std::numeric_limits<double>::quiet_NaN(), last_error = 0.0, last_angle = 0.0;
        for (int k = 0; k <= kClocks; ++k) {
            const double psi =
                clock + (bow.bright_side > 0 ? 0.0 : kPi) + 0.6 * (double(k) / kClocks - 0.5);
            const Vec3 out =
                drop.leave(d, b * (std::cos(psi) * up + std::sin(psi) * right), kWater.value, p);
            const double now = std::acos(dot(out, d));
            const double error =
                std::remainder(std::atan2(dot(out, right), dot(out, up)) - clock - kPi, 2.0 * kPi);
            if (k > 0 && error * last_error <= 0.0 && std::abs(error - last_error) < 1.0)
                angle = last_angle + (now - last_angle) * last_error / (last_error - error);
            last_error = error;
            last_angle = now;
        }
        if (!std::isnan(angle))
            extreme = bow.bright_side > 0 ? std::min(extreme, angle) : std::max(extreme, angle);
    }
    return extreme;
}

TEST(BowShifts, AgreeWithASpheroidTracedByBruteForce) {
    // Linear between 40 clock angles in 0.6 rad: 0.015² / 8 of second derivatives of order e · 10;
    // and places in steps of 2.5e-4, h (step/2)² = 4e-7.
    constexpr double kGrid = 1e-5;
    for (const double e : {0.0087756, 0.036})
        for (const int p : {2, 3})
            for (const double h : {0.0, 20.0, 35.0})
                for (const double chi : {0.0, 30.0, 90.0, 140.0}) {
                    const auto shifts =
                        bow_shifts(kWater, {axis_ratio_of(e)}, {h * deg, chi * deg});
                    const double traced = traced_bow(e, h * kPi / 180.0, chi * kPi / 180.0, p) -
                                          descartes_ray(kWater, p).scattering_angle.to(rad);
                    EXPECT_NEAR(shifts[std::size_t(p)].to(rad), traced, kGrid)
                        << e << " " << p << " " << h << " " << chi;
                }
}

TEST(BowShifts, AtTheTopAreThoseOfAnEllipse) {
    // Exact rays in two dimensions, sun on the horizon.
    const struct {
        double d_mm, primary_deg, digits;
    } tops[] = {{0.5, 0.10, 5e-3},
                {0.75, 0.80, 5e-3},
                {1.0, 1.77, 5e-3},
                {1.5, 4.5, 5e-2},
                {2.0, 8.3, 5e-2}};
    for (const auto& top : tops) {
        const double k = raindrop_axis_ratio(0.5 * top.d_mm * mm);
        EXPECT_NEAR(bow_shifts(kWater, {k}, {})[2].to(deg), top.primary_deg, top.digits);
    }
    // Only the primary is twinned.
    const auto at_1mm = bow_shifts(kWater, {raindrop_axis_ratio(0.5 * mm)}, {});
    EXPECT_NEAR(at_1mm[3].to(deg), -0.12, 5e-3);
    EXPECT_EQ(at_1mm[0].to(deg), 0.0);
    EXPECT_EQ(at_1mm[1].to(deg), 0.0);
    // The feet of the arc stay, with a low sun.
    const auto foot = bow_shifts(kWater, {raindrop_axis_ratio(0.5 * mm)}, {{}, 90.0 * deg});
    EXPECT_NEAR(foot[2].to(deg), 0.0, 1e-3);
}

TEST(BowShifts, TendToTheFirstOrder) {
    // Second order: up to 140 e² for p = 7.
    constexpr double kE = 1e-4, kSecond = 200.0 * kE * kE;
    for (const double h : {0.0, 20.0, 42.0, 60.0})
        for (const double chi : {0.0, 45.0, 80.0, 100.0, 180.0, -30.0}) {
            const BowPlace place{h * deg, chi * deg};
            const auto exact = bow_shifts(kWater, {axis_ratio_of(kE)}, place);
            const auto first = first_order_bow_shifts(kWater, axis_ratio_of(kE), place);
            for (std::size_t p = 2; p <= 7; ++p)
                EXPECT_NEAR(exact[p].to(rad), first[p].to(rad), kSecond)
                    << p << " " << h << " " << chi;
        }
}

TEST(BowShifts, FirstOrderErrsByWhatIsStated) {
    for (const auto& [d_mm, error] : {std::pair{0.75, 0.015}, {1.0, 0.03}, {2.0, 0.12}}) {
        const double k = raindrop_axis_ratio(0.5 * d_mm * mm);
        const double exact = bow_shifts(kWater, {k}, {})[2].to(deg);
        const double first = first_order_bow_shifts(kWater, k, {})[2].to(deg);
        EXPECT_LT(first, exact);
        EXPECT_NEAR(1.0 - first / exact, error, 0.025 * error + 0.005) << d_mm;
    }
}

TEST(BowShifts, KnowTheirSymmetries) {
    constexpr double kRays = 1e-9;
    const double k = raindrop_axis_ratio(0.6 * mm);
    for (std::size_t p = 2; p <= 7; ++p) {
        // A sphere.
        EXPECT_EQ(bow_shifts(kWater, {1.0}, {20.0 * deg, 10.0 * deg})[p], Angle{});
        // Left and right of the arc.
        EXPECT_NEAR(bow_shifts(kWater, {k}, {20.0 * deg, 40.0 * deg})[p].to(rad),
                    bow_shifts(kWater, {k}, {20.0 * deg, -40.0 * deg})[p].to(rad), kRays);
        // An axis that leans to the sun under a higher sun.
        EXPECT_NEAR(bow_shifts(kWater, {k, 5.0 * deg, {}}, {10.0 * deg, 40.0 * deg})[p].to(rad),
                    bow_shifts(kWater, {k}, {15.0 * deg, 40.0 * deg})[p].to(rad), kRays);
        // An axis that leans to the right, in the mirror.
        EXPECT_NEAR(bow_shifts(kWater, {k, {}, 5.0 * deg}, {10.0 * deg, 40.0 * deg})[p].to(rad),
                    bow_shifts(kWater, {k, {}, -5.0 * deg}, {10.0 * deg, -40.0 * deg})[p].to(rad),
                    kRays);
        // The sun on the horizon: a turn of the drop around the light is a turn of the arc.
        EXPECT_NEAR(bow_shifts(kWater, {k, {}, 7.0 * deg}, {{}, 40.0 * deg})[p].to(rad),
                    bow_shifts(kWater, {k}, {{}, 33.0 * deg})[p].to(rad), kRays);
    }
}

TEST(RaindropShapes, HaveTheMomentsAskedFor) {
    EXPECT_EQ(raindrop_shapes(0.5 * mm, {}).size(), 1u);
    EXPECT_EQ(raindrop_shapes(0.5 * mm, {0.2, {}}).size(), 3u);
    EXPECT_EQ(raindrop_shapes(10.0 * um, {0.2, 5.0 * deg}).size(), 1u);  // spheres
    const auto shapes = raindrop_shapes(0.5 * mm, {0.2, 5.0 * deg});
    EXPECT_EQ(shapes.size(), 27u);
    const double k = raindrop_axis_ratio(0.5 * mm), e = (1.0 - k) / (1.0 + k);
    double sum = 0.0, mean = 0.0, square = 0.0, tilt = 0.0;
    for (const WeightedShape& s : shapes) {
        const double now = (1.0 - s.shape.axis_ratio) / (1.0 + s.shape.axis_ratio);
        sum += s.share;
        mean += s.share * now;
        square += s.share * now * now;
        tilt += s.share * std::pow(s.shape.tilt_to_right.to(deg), 2);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(mean, e, 1e-14);
    EXPECT_NEAR(std::sqrt(square - mean * mean) / e, 0.2, 1e-9);
    EXPECT_NEAR(std::sqrt(tilt), 5.0, 1e-12);
    EXPECT_THROW(raindrop_shapes(0.5 * mm, {-0.1, {}}), InputError);
    EXPECT_THROW(raindrop_shapes(0.5 * mm, {0.1, 40.0 * deg}), InputError);
}

}  // namespace
}  // namespace dewbow
