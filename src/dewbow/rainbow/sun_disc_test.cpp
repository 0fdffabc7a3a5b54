// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/sun_disc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kPi = std::numbers::pi;
const SunDisc kEven{}, kDomed{kSunRadius, 0.6}, kPoint{Angle{}, 0.0};

std::vector<Angle> even_angles(std::size_t count) {
    std::vector<Angle> angles;
    for (std::size_t i = 0; i < count; ++i)
        angles.push_back(180.0 * double(i) / double(count - 1) * deg);
    return angles;
}

std::vector<double> smoothed(std::span<const Angle> angles, const SunDisc& disc,
                             const std::function<double(double)>& f) {
    std::vector<double> in, out(angles.size());
    for (const Angle angle : angles) in.push_back(f(angle.to(rad)));
    SunSmoother(angles, disc).apply(in, out);
    return out;
}

/// The mean of f over the disc around a direction at θ, from the law itself: rings around the
/// centre of the disc. Knows nothing of arcs around the direction of view.
struct DiscMean {
    double i = 0.0, q = 0.0;
};
DiscMean disc_mean(double theta, const SunDisc& disc, const std::function<double(double)>& f,
                   const std::function<double(double)>& f_q) {
    constexpr int kRings = 400, kSpokes = 90;
    DiscMean sum;
    double light = 0.0;
    const double sin2 = std::pow(std::sin(0.5 * disc.radius.to(rad)), 2);
    for (int ring = 0; ring < kRings; ++ring) {
        const double share = (ring + 0.5) / kRings;  // of the disc's area
        const double rho = 2.0 * std::asin(std::sqrt(share * sin2));
        const double weight = 1.0 - disc.limb_darkening * (1.0 - std::sqrt(1.0 - share));
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double phi = 2.0 * kPi * (spoke + 0.5) / kSpokes;
            // The view is the pole; the disc's centre stands at θ in the plane of x and z.
            const double x =
                std::sin(theta) * std::cos(rho) + std::cos(theta) * std::sin(rho) * std::cos(phi);
            const double y = std::sin(rho) * std::sin(phi);
            const double z =
                std::cos(theta) * std::cos(rho) - std::sin(theta) * std::sin(rho) * std::cos(phi);
            const double t = std::atan2(std::hypot(x, y), z);
            const double turn = std::atan2(y, x);  // of the scattering plane
            sum.i += weight * f(t);
            sum.q += weight * f_q(t) * std::cos(2.0 * turn);
            light += weight;
        }
    }
    return {sum.i / light, sum.q / light};
}

TEST(LegendreFactor, IsTheClosedFormOfAnEvenDisc) {
    // The closed form cancels: l ε / (l R)² at small l.
    constexpr double kCancellation = 1e-8;
    const double c = cos(kSunRadius);
    double before = 1.0, now = c;  // P_{l−1}, P_l
    for (int l = 1; l <= 3000; ++l) {
        const double next = ((2.0 * l + 1.0) * c * now - l * before) / (l + 1.0);
        if (l % 300 == 0) {
            EXPECT_NEAR(legendre_factor(kEven, l),
                        (before - next) / ((2.0 * l + 1.0) * 2.0 *
                                           std::pow(std::sin(0.5 * kSunRadius.to(rad)), 2)),
                        kCancellation)
                << l;
        }
        before = now;
        now = next;
    }
    EXPECT_EQ(legendre_factor(kEven, 0), 1.0);
    EXPECT_EQ(legendre_factor(kPoint, 1000), 1.0);
    // A disc that is darker at its limb is narrower.
    EXPECT_GT(legendre_factor(kDomed, 300), legendre_factor(kEven, 300));
}

TEST(SunSmoother, MultipliesLegendrePolynomialsByTheirFactor) {
    // Linear interpolation of P_l in steps h errs by h² l² / 12.
    constexpr double kStep_deg = 0.01, kReach_deg = 0.3;
    const double h = kStep_deg * kPi / 180.0;
    for (const SunDisc& disc : {kEven, kDomed})
        for (const double from : {0.0, 89.0, 137.0, 178.5}) {
            std::vector<Angle> angles;
            for (int k = 0; k <= 150; ++k) angles.push_back((from + kStep_deg * k) * deg);
            const SunSmoother smoother(angles, disc);
            for (const int l : {1, 2, 10, 100, 400}) {
                const auto p = [&](Angle theta) { return std::legendre(unsigned(l), cos(theta)); };
                std::vector<double> in, out(angles.size());
                for (const Angle angle : angles) in.push_back(p(angle));
                smoother.apply(in, out);
                const double factor = legendre_factor(disc, l);
                for (std::size_t i = 0; i < angles.size(); ++i) {
                    const double d = angles[i].to(deg), end = from + kStep_deg * 150;
                    if ((from > 0.0 && d < from + kReach_deg) ||
                        (end < 180.0 - 1e-9 && d > end - kReach_deg))
                        continue;  // the disc reaches beyond the angles
                    ASSERT_NEAR(out[i], factor * p(angles[i]), 1e-7 + h * h * l * l / 12.0)
                        << l << " " << d;
                }
            }
        }
}

TEST(SunSmoother, AgreesWithADiscOfRingsInBothPolarisations) {
    // Q vanishes at both poles like the square of the distance, as that of any sphere does.
    const auto f = [](double t) { return 1.0 + std::cos(300.0 * t); };
    const auto f_q = [](double t) { return std::pow(std::sin(t), 2) * 1e4 * std::cos(100.0 * t); };
    constexpr double kStep_deg = 0.004;
    /// Of the rings, midpoints; and h² f″ / 12 of f, 4e-5, and of f_q near the poles, where f_q″ is
    /// 2e4: 8e-6.
    constexpr double kRings = 6e-5;
    for (const SunDisc& disc : {kEven, kDomed})
        for (const double degrees :
             {0.0, 0.052, 0.2, 0.26, 0.272, 0.6, 5.0, 138.0, 179.7, 179.9, 180.0}) {
            // From the nearest pole, or 0.3° to both sides.
            const double from = std::max(0.0, degrees - 0.3), to = std::min(180.0, degrees + 0.3);
            std::vector<Angle> angles;
            for (double d = from; d < to + 1e-9; d += kStep_deg)
                angles.push_back(std::min(d, 180.0) * deg);
            std::vector<Intensities> in, out(angles.size());
            for (const Angle angle : angles) {
                const double i = f(angle.to(rad)), q = f_q(angle.to(rad));
                in.push_back({i + q, i - q});
            }
            SunSmoother(angles, disc).apply(in, out);
            const auto index = std::size_t(std::lround((degrees - from) / kStep_deg));
            ASSERT_NEAR(angles[index].to(deg), degrees, 1e-9);
            const DiscMean mean = disc_mean(angles[index].to(rad), disc, f, f_q);
            const double q = 0.5 * (out[index].perpendicular - out[index].parallel);
            const double scale = 1.0 + std::pow(std::sin(degrees * kPi / 180.0), 2) * 1e4;
            EXPECT_NEAR(out[index].unpolarised(), mean.i, kRings) << degrees;
            EXPECT_NEAR(q / scale, mean.q / scale, kRings) << degrees;
        }
}

TEST(SunSmoother, KeepsConstantsAndTheIntegralOverTheSphere) {
    const auto bow = [](double t) {
        return 0.1 + std::exp(-std::pow((t - 2.4) / 0.004, 2)) + std::exp(-300.0 * t);
    };
    for (const SunDisc& disc : {kEven, kDomed, kPoint}) {
        const std::vector<Angle> angles = even_angles(1801);
        for (const double one : smoothed(angles, disc, [](double) { return 1.0; }))
            ASSERT_NEAR(one, 1.0, 1e-14);
        // The integral of the polyline, ∫ hat sin θ dθ, before and after.
        const std::vector<double> out = smoothed(angles, disc, bow);
        double before = 0.0, after = 0.0;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            before += bow(angles[i].to(rad)) * sin(angles[i]);
            after += out[i] * sin(angles[i]);
        }
        EXPECT_NEAR(after / before, 1.0, 1e-5) << disc.limb_darkening;
    }
}

TEST(SunSmoother, TakesAnglesAsTheyCome) {
    // Fine at the bow, coarse elsewhere: the same values as on a fine grid wherever the function is
    // straight between the coarse angles.
    const auto bow = [](double t) {
        return 1.0 + 0.1 * t + std::exp(-std::pow((t - 2.4) / 0.003, 2));
    };
    std::vector<Angle> uneven;
    for (double d = 0.0; d < 135.0; d += 0.5) uneven.push_back(d * deg);
    for (double d = 135.0; d < 140.0; d += 0.01) uneven.push_back(d * deg);
    for (double d = 140.0; d <= 180.0; d += 0.5) uneven.push_back(d * deg);
    const std::vector<double> out = smoothed(uneven, kEven, bow);
    const std::vector<Angle> even = even_angles(18001);
    const std::vector<double> fine = smoothed(even, kEven, bow);
    for (std::size_t i = 0; i < uneven.size(); ++i)
        EXPECT_NEAR(out[i], fine[std::size_t(std::lround(uneven[i].to(deg) * 100.0))], 2e-4)
            << uneven[i].to(deg);
    // A part of the sphere: beyond the ends their values hold.
    std::vector<Angle> part;
    for (double d = 120.0; d < 150.0; d += 0.1) part.push_back(d * deg);
    EXPECT_NEAR(smoothed(part, kEven, [](double) { return 2.0; }).front(), 2.0, 1e-14);
    EXPECT_EQ(smoothed(std::vector{90.0 * deg}, kEven, [](double) { return 3.0; })[0], 3.0);
}

TEST(SunSmoother, LeavesAPointAlone) {
    const std::vector<Angle> angles = even_angles(19);
    const std::vector<double> out = smoothed(angles, kPoint, [](double t) { return t; });
    for (std::size_t i = 0; i < angles.size(); ++i) EXPECT_EQ(out[i], angles[i].to(rad));
}

TEST(SunSmoother, TreatsColumnsAlike) {
    const std::vector<Angle> angles = even_angles(181);
    std::vector<Intensities> in(181 * 3), out(181 * 3), one(181), one_out(181);
    for (std::size_t i = 0; i < 181; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            in[3 * i + c] = {double((i * 7 + c * 5) % 11), double((i * 3 + c) % 7)};
    const SunSmoother smoother(angles, {1.5 * deg, 0.3});
    smoother.apply(in, out);
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < 181; ++i) one[i] = in[3 * i + c];
        smoother.apply(one, one_out);
        for (std::size_t i = 0; i < 181; ++i) {
            EXPECT_EQ(one_out[i].perpendicular, out[3 * i + c].perpendicular);
            EXPECT_EQ(one_out[i].parallel, out[3 * i + c].parallel);
        }
    }
}

TEST(SunSmoother, RefusesWhatIsNoDiscOrNoGrid) {
    const std::vector<Angle> good = even_angles(3), empty, twice = {1.0 * deg, 1.0 * deg},
                             outside = {0.0 * deg, 181.0 * deg};
    EXPECT_THROW(SunSmoother(good, {-0.1 * deg, 0.0}), InputError);
    EXPECT_THROW(SunSmoother(good, {11.0 * deg, 0.0}), InputError);
    EXPECT_THROW(SunSmoother(good, {kSunRadius, 1.1}), InputError);
    EXPECT_THROW(SunSmoother(good, {std::nan("") * deg, 0.0}), InputError);
    EXPECT_THROW(SunSmoother(empty, {}), InputError);
    EXPECT_THROW(SunSmoother(twice, {}), InputError);
    EXPECT_THROW(SunSmoother(outside, {}), InputError);
}

TEST(DiscProfile, IntegratesToOneAndIsWhatIsLeftOfAPeak) {
    for (const SunDisc& disc : {kEven, kDomed}) {
        double sum = 0.0;
        constexpr int kSteps = 20000;
        const double step = disc.radius.to(rad) / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const double t = (i + 0.5) * step;
            sum += disc_profile(disc, t * rad) * 2.0 * kPi * std::sin(t) * step;
        }
        EXPECT_NEAR(sum, 1.0, 1e-6);
        EXPECT_EQ(disc_profile(disc, 1.001 * disc.radius), 0.0);
        // A narrow peak through the filter itself: a polyline in steps h holds h²/6w² = 0.7 %
        // more than a Gaussian of width w, the profile blurs less.
        constexpr double kPolyline = 8e-3;
        std::vector<Angle> angles;
        for (double d = 0.0; d < 0.6; d += 0.004) angles.push_back(d * deg);
        const double width = 0.02 * kPi / 180.0;
        const auto out = smoothed(angles, disc, [&](double t) {
            return std::exp(-t * t / (width * width)) / (kPi * width * width);
        });
        for (const double d : {0.0, 0.1, 0.2})
            EXPECT_NEAR(out[std::size_t(std::lround(d / 0.004))] / disc_profile(disc, d * deg), 1.0,
                        kPolyline)
                << d;
    }
    EXPECT_EQ(disc_profile(kPoint, 0.1 * deg), 0.0);
}

TEST(ProjectionKernel, IsThePublishedSevenTaps) {
    // Reference values with R = 0.2666°, four digits.
    const double even[] = {.0092, .1525, .2196, .2374, .2196, .1525, .0092};
    const double domed[] = {.0060, .1361, .2290, .2577, .2290, .1361, .0060};
    const auto check = [](const std::vector<double>& taps, const double* expected) {
        ASSERT_EQ(taps.size(), 7u);
        double sum = 0.0;
        for (int k = 0; k < 7; ++k) {
            EXPECT_NEAR(taps[k], expected[k], 6e-5);
            sum += taps[k];
        }
        EXPECT_NEAR(sum, 1.0, 1e-14);
    };
    check(projection_kernel({0.2666 * deg, 0.0}, 0.1 * deg), even);
    check(projection_kernel({0.2666 * deg, 0.6}, 0.1 * deg), domed);
    EXPECT_EQ(projection_kernel(kPoint, 0.1 * deg), std::vector{1.0});
    EXPECT_EQ(projection_kernel(kEven, 10.0 * deg).size(), 1u);
    EXPECT_THROW(projection_kernel(kEven, Angle{}), InputError);
    // rms: R/2, and less by (1 − 7u/15) / (1 − u/3) with darkening.
    const auto rms = [](const SunDisc& disc) {
        const std::vector<double> taps = projection_kernel(disc, 0.001 * deg);
        double sum = 0.0;
        for (std::size_t k = 0; k < taps.size(); ++k) {
            const double s = 0.001 * (double(k) - double(taps.size() / 2));
            sum += taps[k] * s * s;
        }
        return std::sqrt(sum);
    };
    EXPECT_NEAR(rms({0.2666 * deg, 0.0}), 0.1333, 1e-6);
    EXPECT_NEAR(rms({0.2666 * deg, 0.6}), 0.1265, 5e-5);
}

TEST(ProjectionKernel, IsTheSphericalFilterFarFromThePoles) {
    // A step at 90°, where circles of equal scattering angle are straight.
    std::vector<Angle> angles;
    for (int k = -100; k <= 100; ++k) angles.push_back((90.0 + 0.005 * k) * deg);
    const auto out = smoothed(angles, kDomed, [](double t) { return t < 0.5 * kPi ? 0.0 : 1.0; });
    const std::vector<double> taps = projection_kernel(kDomed, 0.005 * deg);
    double below = 0.0;
    const int reach = int(taps.size()) / 2;
    for (int k = -reach; k <= reach; ++k) {
        below += taps[std::size_t(k + reach)];
        // Bins end half a step above; the polyline of the step is centred half a step below.
        EXPECT_NEAR(out[std::size_t(100 + k)], below, 1e-4) << k;
    }
}

TEST(PublishedSunKernel, HasItsFiveEntries) {
    const double expected[] = {.1488, .2273, .2480, .2273, .1488};
    const auto taps = published_sun_kernel();
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(taps[std::size_t(k)], expected[k], 5e-5);
}

}  // namespace
}  // namespace dewbow
