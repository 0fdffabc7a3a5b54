// SPDX-License-Identifier: Apache-2.0

// White seen through a slab by jittered samples: the noise that the paper calls faint, how often it
// is beyond white, and what clamping makes of it.      [Musgrave 1989, 4.2.1]

#include <gtest/gtest.h>

#include "../analytic/kit_of_1989.h"
#include "../analytic/statistics.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kSide = 96;
constexpr double kPixels = double(kSide) * kSide;

/// A slab that fills the view, in white light. Each pixel is one set of samples. Of light that is
/// reflected inside 1e-12 is lost with the depth.
Scene slab_in_white(Jitter jitter, SampleSum sum) {
    Scene scene = scene_of_tests(kSide, kSide, 14);
    scene.lights.push_back(UniformEnvironment{film_white()});
    add(scene, Box{20.0 * m, 20.0 * m, 1.0 * m}, dielectric(glass_of_1989()));
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}));
    scene.camera.projection = Perspective{1.0 * deg};  // the same Fresnel factor everywhere
    scene.render.distributed_1989.sampling.jitter = jitter;
    scene.render.distributed_1989.sum = sum;
    return scene;
}

/// Of fixed point sums, and of the way from the monitor to the film and back.
constexpr double kRounding = 1e-6;

/// What is not reflected by the first face, which all of the samples share.
double share() {
    const double n = eta_of(paper_coordinate(kLineD, SpectralSpacing::frequency));
    return 1.0 - (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
}

/// Of the sets alone: what the faces reflect is taken off, white = 1.
struct SetStatistics {
    std::array<double, 3> mean{}, deviation{};
    double any_above = 0.0;  ///< share of the sets with a channel above white
    std::array<double, 3> above{};
};
SetStatistics statistics_of(const Scene& scene) {
    SetStatistics result;
    std::array<kit::MeanSums, 3> beyond;
    for (const MonitorRgb& pixel : monitor_picture(scene)) {
        bool any = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double above = (pixel[c] - 1.0) / share();
            beyond[c].add(above);
            result.above[c] += (above > kRounding) / kPixels;
            any = any || above > kRounding;
        }
        result.any_above += any / kPixels;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        result.mean[c] = 1.0 + beyond[c].mean();
        result.deviation[c] = beyond[c].standard_error() * std::sqrt(kPixels - 1.0);
    }
    return result;
}

/// A channel's sum is 1 + Σ h_i (U_i − ½)/6 over the intervals in which its curve rises or falls by
/// h_i: two of 1 and four of ½ of red, four of ½ of green, two of 1 of blue.
struct Ramps {
    int whole, halves;
};
constexpr std::array<Ramps, 3> kRamps{{{2, 4}, {0, 4}, {2, 0}}};

double expected_deviation(Ramps ramps) {
    return std::sqrt((ramps.whole + 0.25 * ramps.halves) / 12.0) / kPaperWhite;
}
/// E min(sum, 1) = 1 − E|X| / 12 with X six times what the sum is above 1; E|X| by its
/// characteristic function φ: (2/π) ∫ (1 − φ(t)) / t² dt.
double expected_clamped(Ramps ramps) {
    const auto phi = [&](double t) {
        const double whole = std::sin(0.5 * t) / (0.5 * t), half = std::sin(0.25 * t) / (0.25 * t);
        return std::pow(whole, ramps.whole) * std::pow(half, ramps.halves);
    };
    constexpr double kEnd = 200.0, kStep = 1e-3;  // beyond it the integral of 1/t² is 1/kEnd
    double integral = 1.0 / kEnd;
    for (double t = 0.5 * kStep; t < kEnd; t += kStep) integral += kStep * (1.0 - phi(t)) / (t * t);
    return 1.0 - 2.0 / kPi * integral / (2.0 * kPaperWhite);
}

/// Quantile for a false alarm in 1e6 of each comparison below, two-sided.
constexpr double kSigmas = 4.9;
/// Of a standard deviation, for sums of uniform numbers (their tails are below a Gaussian's).
const double kDeviationError = kSigmas / std::sqrt(2.0 * kPixels);

bool noise_is_right(const SetStatistics& sets) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected = expected_deviation(kRamps[c]);
        if (std::abs(sets.deviation[c] / expected - 1.0) > kDeviationError) return false;
        if (std::abs(sets.mean[c] - 1.0) > kSigmas * expected / std::sqrt(kPixels)) return false;
    }
    return true;
}

TEST(JitterOf1989, NoiseOfWhiteIsThatOfTheCurves) {
    const SetStatistics sets = statistics_of(slab_in_white(Jitter::both, SampleSum::free));
    std::printf("    standard deviation %.2f %.2f %.2f %%, any channel above white %.3f\n",
                100.0 * sets.deviation[0], 100.0 * sets.deviation[1], 100.0 * sets.deviation[2],
                sets.any_above);
    EXPECT_TRUE(noise_is_right(sets));
    // The figures of the page that derives them.
    EXPECT_NEAR(sets.deviation[0], 0.083, 0.003);
    EXPECT_NEAR(sets.deviation[1], 0.048, 0.002);
    EXPECT_NEAR(sets.deviation[2], 0.068, 0.003);
    const double half_error = kSigmas * 0.5 / std::sqrt(kPixels);
    for (const double above : sets.above) EXPECT_NEAR(above, 0.5, half_error);
    EXPECT_NEAR(sets.any_above, 0.84, 0.005 + half_error);  // two digits are known
}

TEST(JitterOf1989, PlantedFaultsAreSeen) {
    // Twelve intervals; one offset for all; none.
    Scene scene = slab_in_white(Jitter::both, SampleSum::free);
    scene.render.distributed_1989.sampling.samples = 12;
    EXPECT_FALSE(noise_is_right(statistics_of(scene)));
    scene = slab_in_white(Jitter::both, SampleSum::free);
    scene.render.distributed_1989.sampling.correlated = true;
    EXPECT_FALSE(noise_is_right(statistics_of(scene)));
    EXPECT_FALSE(noise_is_right(statistics_of(slab_in_white(Jitter::none, SampleSum::free))));
    EXPECT_FALSE(noise_is_right(statistics_of(slab_in_white(Jitter::both, SampleSum::clamp))));
}

TEST(JitterOf1989, ClampingDarkensWhite) {
    const SetStatistics sets = statistics_of(slab_in_white(Jitter::both, SampleSum::clamp));
    constexpr std::array<double, 3> kPage{0.966, 0.981, 0.972};
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected = expected_clamped(kRamps[c]);
        EXPECT_NEAR(sets.mean[c], expected, kSigmas * sets.deviation[c] / std::sqrt(kPixels)) << c;
        EXPECT_NEAR(expected, kPage[c], 0.0006) << c;  // three digits
        EXPECT_EQ(sets.above[c], 0.0);
    }
    std::printf("    clamped white %.4f %.4f %.4f\n", sets.mean[0], sets.mean[1], sets.mean[2]);
}

TEST(JitterOf1989, MovingTheIndexAloneOrAllTogetherAddsNoNoise) {
    Scene scene = slab_in_white(Jitter::index, SampleSum::free);
    for (const double deviation : statistics_of(scene).deviation) EXPECT_LT(deviation, kRounding);
    scene = slab_in_white(Jitter::both, SampleSum::free);
    scene.render.distributed_1989.sampling.correlated = true;
    for (const double deviation : statistics_of(scene).deviation) EXPECT_LT(deviation, kRounding);
}

}  // namespace
}  // namespace dewbow
