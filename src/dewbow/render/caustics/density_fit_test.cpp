// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/density_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace dewbow::caustics {
namespace {

using Function = std::function<double(const AimPoint&)>;

constexpr int kObservations = 40'000;

AimPoint random_point(std::mt19937_64& random) {
    AimPoint u;
    for (double& x : u) x = double(random() >> 11) * 0x1p-53;
    return u;
}

/// What evenly spread samples see of `f`, which is at most `most`.
std::vector<DensityObservation> observe(const Function& f, double most) {
    std::mt19937_64 random(3);
    std::vector<DensityObservation> observations;
    for (int i = 0; i < kObservations; ++i) {
        const AimPoint at = random_point(random);
        const double weight = f(at) * f(at) / (most * most);
        if (weight > 0.0) observations.push_back({at, std::uint32_t(1.0 + weight * 0x1p30)});
    }
    return observations;
}

LearntDensity fit(const Function& f, double most) {
    std::vector<DensityObservation> observations = observe(f, most);
    return fit_density(observations, {});
}

/// Mean and mean square of f/p over samples of p.
struct Moments {
    double mean, square;
    double variance() const { return square - mean * mean; }
};
Moments estimate(const LearntDensity& p, const Function& f) {
    constexpr int kSamples = 400'000;
    std::mt19937_64 random(4);
    Moments moments{};
    for (int i = 0; i < kSamples; ++i) {
        const LearntDensity::Sample sample = p.sample(random_point(random));
        const double x = f(sample.at) / sample.density;
        moments.mean += x / kSamples, moments.square += x * x / kSamples;
    }
    return moments;
}

// f = ∏ 2x of the four coordinates of a ray: ∫ f = 1, and with even samples the variance is
// (4/3)⁴ − 1 = 2.16.
double product(const AimPoint& at) { return 16.0 * at[1] * at[2] * at[3] * at[4]; }
constexpr double kVarianceOfEven = 256.0 / 81.0 - 1.0;

/// ∫ f²/p − 1 for the product, where p is constant in each cell of a grid of 2⁻⁵.
double variance_by_theory(const LearntDensity& p) {
    constexpr int kFine = 32;
    double sum = 0.0;
    AimPoint at{0.5, 0, 0, 0, 0};
    const auto add = [&](const auto& self, std::size_t axis, double integral) -> void {
        if (axis == kAimDimensions) {
            sum += integral / p.density(at);
            return;
        }
        for (int i = 0; i < kFine; ++i) {
            const double low = double(i) / kFine, high = double(i + 1) / kFine;
            at[axis] = 0.5 * (low + high);
            self(self, axis + 1,
                 integral * 4.0 / 3.0 * (high * high * high - low * low * low));  // ∫ (2x)²
        }
    };
    add(add, 1, 1.0);
    return sum - 1.0;
}

TEST(DensityFit, LowersTheVarianceOfAProductByWhatTheorySays) {
    const LearntDensity p = fit(product, 16.0);
    const Moments learnt = estimate(p, product);
    const double expected = variance_by_theory(p);
    // Standard errors of 4·10⁵ samples: of the mean √(0.1/4e5) = 5e-4, of the variance, whose
    // fourth moment is a few times its square, below 1 %. Five of each.
    EXPECT_NEAR(learnt.mean, 1.0, 2.5e-3);
    EXPECT_NEAR(learnt.variance(), expected, 0.05 * expected);
    // Measured: 0.16.
    EXPECT_LT(expected, kVarianceOfEven / 10.0);
}

// The variance by theory is that of the cuts and masses: twice the share of one leaf shows.
TEST(DensityFit, TheoryTellsAnotherDensity) {
    const LearntDensity even;
    EXPECT_NEAR(variance_by_theory(even), kVarianceOfEven, 1e-9);  // a million roundings
}

// A slit makes of place and direction a ridge: even along each axis, and nearly empty.
double ridge(const AimPoint& at) {
    return std::abs(at[1] - at[3]) < 0.05 && std::abs(at[2] - at[4]) < 0.1 ? 1.0 : 0.0;
}

TEST(DensityFit, FindsARidgeThatIsEvenAlongEveryAxis) {
    // ∫ f = ∫ f² = 0.0975 · 0.19: with even samples the relative variance is 53.
    constexpr double kArea = 0.0975 * 0.19;
    const Moments learnt = estimate(fit(ridge, 1.0), ridge);
    EXPECT_NEAR(learnt.mean, kArea, 0.02 * kArea);  // six standard errors
    // Measured: 9.
    EXPECT_LT(learnt.variance() / (kArea * kArea), (1.0 / kArea - 1.0) / 4.0);
}

TEST(DensityFit, FindsAHumpInTheMiddle) {
    const Function hump = [](const AimPoint& at) {
        double r2 = 0.0;
        for (std::size_t k = 1; k < kAimDimensions; ++k) r2 += (at[k] - 0.5) * (at[k] - 0.5);
        return std::exp(-r2 / 0.02);
    };
    EXPECT_LT(estimate(fit(hump, 1.0), hump).variance(),
              estimate(LearntDensity(), hump).variance() / 25.0);  // measured: 1/36
}

// Heavy weights, evenly spread, say nothing.
TEST(DensityFit, LearnsNothingFromChance) {
    std::mt19937_64 random(6);
    std::vector<DensityObservation> observations;
    for (int i = 0; i < kObservations; ++i) {
        const double u = double(random() >> 11) * 0x1p-53;
        observations.push_back({random_point(random),
                                std::uint32_t(std::min(0x1p31, 1000.0 * std::pow(1.0 - u, -0.8)))});
    }
    EXPECT_EQ(fit_density(observations, {}).leaves(), 1u);
}

TEST(DensityFit, HasNothingToLearnFromNothing) {
    std::vector<DensityObservation> none;
    EXPECT_EQ(fit_density(none, {}).leaves(), 1u);
}

// Two lamps, of which the one that is chosen less often brings everything.
TEST(DensityFit, CutsBetweenLamps) {
    std::mt19937_64 random(7);
    const std::vector<double> edges{0.37, 0.9, 1.0};
    std::vector<DensityObservation> observations;
    for (int i = 0; i < kObservations; ++i) {
        const AimPoint at = random_point(random);
        if (at[0] < 0.37) observations.push_back({at, 1'000'000});
    }
    const LearntDensity p = fit_density(observations, edges);
    const auto density = [&](double choice) { return p.density({choice, 0.5, 0.5, 0.5, 0.5}); };
    EXPECT_NEAR(density(0.0), 0.1 + 0.9 / 0.37, 0.05);  // a little is held by the box around
    EXPECT_EQ(density(0.0), density(std::nextafter(0.37, 0.0)));
    EXPECT_LT(density(0.37), 0.2);
    EXPECT_GE(density(0.95), kUniformShare);
}

TEST(DensityFit, DoesNotDependOnTheOrder) {
    std::vector<DensityObservation> observations = observe(ridge, 1.0), reversed = observations;
    std::reverse(reversed.begin(), reversed.end());
    const LearntDensity a = fit_density(observations, {}), b = fit_density(reversed, {});
    EXPECT_EQ(a.leaves(), b.leaves());
    std::mt19937_64 random(8);
    for (int i = 0; i < 10'000; ++i) {
        const AimPoint at = random_point(random);
        ASSERT_EQ(a.density(at), b.density(at));
    }
}

}  // namespace
}  // namespace dewbow::caustics
