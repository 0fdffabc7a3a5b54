// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/size_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kPi = std::numbers::pi;

const std::vector<std::string> kContinuous = {"normal:mean=0.5mm,width=10%",
                                              "normal:mean=0.5mm,width=1%",
                                              "normal:mean=10um,width=20%",
                                              "lognormal:mean=0.3mm,width=5%",
                                              "lognormal:mean=10um,width=50%",
                                              "gamma:mean=0.2mm,width=30%",
                                              "gamma:mean=0.2mm,width=100%",
                                              "deirmendjian:cloud-c1",
                                              "deirmendjian:haze-m",
                                              "fog:strong-advection",
                                              "rain:marshall-palmer,rate=5mm/h",
                                              "rain:marshall-palmer,rate=100mm/h",
                                              "rain:ulbrich,rate=20mm/h,shape=3"};

/// The sum over the radii of share · f(r in m).
template <class F>
auto sum_over(const std::vector<WeightedRadius>& radii, const F& f) {
    decltype(f(0.0)) sum{};
    for (const WeightedRadius& drop : radii) sum += drop.share * f(drop.radius.to(m));
    return sum;
}

/// ∫ n f dr by Gauss's rule in panels, even in r: knows nothing of the sampling.
template <class F>
auto integral(const DropSizes& sizes, const F& f) {
    static const QuadratureRule rule = gauss_legendre(16);
    constexpr int kPanels = 64;
    const double a = sizes.smallest().to(m), width = (sizes.largest().to(m) - a) / kPanels;
    decltype(f(0.0)) sum{};
    for (int i = 0; i < kPanels; ++i)
        sum += integrate(rule, a + i * width, a + (i + 1) * width,
                         [&](double r) { return sizes.density(r * m) * f(r); });
    return sum;
}

TEST(SampleSizes, SharesSumToOneAndMomentsAreExact) {
    constexpr double kStated = 1e-6;
    constexpr double kRounding = 1e-12;
    for (const std::string& text : kContinuous)
        for (const double error : {1e-6, 1e-3, 0.1}) {
            const DropSizesPtr sizes = parse_drop_sizes(text);
            const auto radii = sample_sizes(*sizes, {.error = error});
            EXPECT_NEAR(sum_over(radii, [](double) { return 1.0; }), 1.0, kRounding) << text;
            for (const int power : {2, 3})
                EXPECT_NEAR(sum_over(radii, [&](double r) { return std::pow(r, power); }) /
                                sizes->mean_power(power),
                            1.0, kStated)
                    << text << " " << power;
            for (std::size_t i = 0; i < radii.size(); ++i) {
                EXPECT_GE(radii[i].share, 0.0) << text;
                if (i > 0) {
                    EXPECT_GT(radii[i].radius, radii[i - 1].radius) << text;
                }
            }
        }
}

TEST(SampleSizes, FringesUpToTheFastestComeOutRight) {
    for (const std::string& text : kContinuous) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        const double range = (sizes->largest() - sizes->smallest()).to(m);
        const double whole = sizes->mean_power(2.0);
        for (const double fringes : {3.0, 40.0})
            for (const double error : {1e-2, 1e-4}) {
                const double fastest = fringes / range;
                const auto radii = sample_sizes(*sizes, {.fastest = fastest / m, .error = error});
                double worst = 0.0;
                for (double f = 0.0; f <= 1.001 * fastest; f += fastest / 24.0) {
                    const auto wave = [&](double r) {
                        return r * r * std::polar(1.0, 2.0 * kPi * f * r);
                    };
                    worst = std::max(
                        worst, std::abs(sum_over(radii, wave) - integral(*sizes, wave)) / whole);
                }
                EXPECT_LT(worst, error) << text << " " << fringes << " " << radii.size();
            }
    }
}

TEST(SampleSizes, TakesNoMoreRadiiThanNeeded) {
    // Half as many must be wrong by far more than the error: the count is no reserve in disguise.
    for (const std::string text : {"normal:mean=0.5mm,width=10%", "gamma:mean=0.2mm,width=30%"}) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        constexpr double kFringes = 60.0, kError = 1e-3;
        const InverseLength fastest = kFringes / (sizes->largest() - sizes->smallest());
        const auto radii = sample_sizes(*sizes, {.fastest = fastest, .error = kError});
        std::vector<WeightedRadius> half;
        for (std::size_t i = 0; i < radii.size(); i += 2)
            half.push_back({radii[i].radius, 2.0 * radii[i].share});
        double worst = 0.0;
        for (double f = 0.0; f <= fastest.to(1.0 / m); f += fastest.to(1.0 / m) / 50.0) {
            const auto wave = [&](double r) { return r * r * std::polar(1.0, 2.0 * kPi * f * r); };
            worst = std::max(worst, std::abs(sum_over(half, wave) - integral(*sizes, wave)));
        }
        EXPECT_GT(worst / sizes->mean_power(2.0), 100.0 * kError) << text;
    }
    // README's example: 10° inside the bow of 0.5 mm ± 10 % drops, 40 fringes, wants about 80
    // radii.
    const DropSizesPtr sizes = parse_drop_sizes("normal:mean=0.5mm,width=10%");
    const InverseLength rate = fringe_rate(10.0 * deg, 4.8992, 550e-9 * m);
    EXPECT_NEAR((rate * (0.5 * mm)), 40.0, 1.0);
    EXPECT_LT(sample_sizes(*sizes, {.fastest = rate}).size(), 70u);
    EXPECT_LT(sample_sizes(*sizes, {}).size(), 16u);
}

/// Airy's function, by its integral (1/π) ∫ cos(t³/3 + zt) dt turned into the complex plane, where
/// it falls off: a slow stand-in. For z >= −400.
double airy(double z) {
    // t = x + i y with y constant: Ai = (1/2π) ∫ exp(i (t³/3 + z t)) dx.
    constexpr double kShift = 1.0, kStep = 0.02, kEnd = 40.0;
    std::complex<double> sum = 0.0;
    for (double x = -kEnd; x <= kEnd; x += kStep) {
        const std::complex<double> t{x, kShift};
        sum += std::exp(std::complex<double>{0.0, 1.0} * (t * t * t / 3.0 + z * t));
    }
    return (sum * kStep).real() / (2.0 * kPi);
}

TEST(SampleSizes, HalvingTheStepChangesTheBowByLessThanTheError) {
    // Intensity x^{7/3} Ai²(−z) of the bow of 0.1 mm ± 15 % drops up to 4° inside, in means of the
    // bow's peak. The envelope of Ai² rises to 1 at the bow and x^{7/3} Ai² goes like r² outside.
    constexpr double kH = 4.8992, kWavelength_m = 550e-9, kError = 1e-3;
    const DropSizesPtr sizes = parse_drop_sizes("normal:mean=0.1mm,width=15%");
    ASSERT_NEAR(airy(0.0), 0.355028053887817, 1e-9);   // Abramowitz & Stegun 1964, 10.4.4
    ASSERT_NEAR(airy(-5.0), 0.350761009024114, 1e-9);  // table 10.11
    const auto bow = [&](const std::vector<WeightedRadius>& radii, double degrees) {
        return sum_over(radii, [&](double r) {
            const double x = 2.0 * kPi * r / kWavelength_m;
            const double ai = airy(-degrees * kPi / 180.0 * std::cbrt(x * x / kH));
            return std::pow(x, 7.0 / 3.0) * ai * ai;
        });
    };
    const InverseLength rate = fringe_rate(4.0 * deg, kH, kWavelength_m * m);
    const auto radii = sample_sizes(*sizes, {.fastest = rate, .error = kError});
    const auto finer = sample_sizes(
        *sizes, {.fastest = 2.0 * rate + washed_out_rate(*sizes, kError), .error = kError});
    ASSERT_GT(finer.size(), 1.8 * radii.size());
    double peak = 0.0, worst = 0.0;
    for (double degrees = -1.0; degrees <= 4.0; degrees += 0.1) {
        const double fine = bow(finer, degrees);
        peak = std::max(peak, fine);
        worst = std::max(worst, std::abs(bow(radii, degrees) - fine));
    }
    EXPECT_LT(worst / peak, kError);
}

TEST(WashedOutRate, IsThatOfAGaussian) {
    // Of r² times a normal distribution of 2 %, nearly one itself: contrast e^{−2(π f σ)²}.
    constexpr double kOfR2 = 0.01;
    const DropSizesPtr sizes = parse_drop_sizes("normal:mean=0.5mm,width=2%");
    const double sigma_m = 1e-5;
    for (const double contrast : {0.1, 0.01})
        EXPECT_NEAR(washed_out_rate(*sizes, contrast).to(1.0 / m) * kPi * sigma_m,
                    std::sqrt(-0.5 * std::log(contrast)), kOfR2);
    // An exponential with r²: (1 + (2π f s)²)^{−3/2}.
    const DropSizesPtr rain = parse_drop_sizes("gamma:mean=0.2mm,width=100%");
    EXPECT_NEAR(washed_out_rate(*rain, 0.01).to(1.0 / m) * 2.0 * kPi * 2e-4,
                std::sqrt(std::pow(0.01, -2.0 / 3.0) - 1.0), kOfR2);
    EXPECT_EQ(washed_out_rate(*single_drop_size(1.0 * mm), 0.01).base_value(),
              std::numeric_limits<double>::infinity());
}

TEST(SampleSizes, OfOneSizeIsThatSize) {
    const auto radii = sample_sizes(*single_drop_size(0.5 * mm), {.fastest = 1e9 / m});
    ASSERT_EQ(radii.size(), 1u);
    EXPECT_EQ(radii[0].radius, 0.5 * mm);
    EXPECT_EQ(radii[0].share, 1.0);
}

TEST(SampleSizes, LeavesSmallDropsToModelsThatKnowThem) {
    // An exponential of 0.2 mm: 2.5 % of the drops are below 5 µm, with 1e-5 of the cross section.
    const DropSizesPtr sizes = parse_drop_sizes("gamma:mean=0.2mm,width=100%");
    const auto all = sample_sizes(*sizes, {});
    const auto merged = sample_sizes(*sizes, {.least = 5.0 * um});
    EXPECT_LT(merged.size(), all.size());
    EXPECT_EQ(merged.front().radius, 5.0 * um);
    EXPECT_NEAR(sum_over(merged, [](double) { return 1.0; }), 1.0, 1e-12);
    EXPECT_NEAR(sum_over(merged, [](double r) { return r * r; }) / sizes->mean_power(2.0), 1.0,
                1e-4);
    // Where they matter they stay.
    EXPECT_EQ(sample_sizes(*sizes, {.least = 100.0 * um}).size(), all.size());
}

TEST(SampleSizes, RefusesWhatWouldNeverEnd) {
    const DropSizesPtr sizes = parse_drop_sizes("normal:mean=0.5mm,width=10%");
    EXPECT_THROW(sample_sizes(*sizes, {.fastest = 1e12 / m}), InputError);
    EXPECT_THROW(sample_sizes(*sizes, {.error = 0.0}), InputError);
}

}  // namespace
}  // namespace dewbow
