// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/chaos.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;

/// A point, the same for the same number, within ±500 along each axis.
Vec3 point(std::uint64_t number) {
    const auto part = [&](std::uint64_t axis) {
        return 1000.0 * (double(hash_combine(number, axis) >> 11) * 0x1p-53 - 0.5);
    };
    return {part(1), part(2), part(3)};
}

Vec3 direction(std::uint64_t number) { return normalised(point(number + 1'000'000)); }

/// Radix-2 fast Fourier transform; the length is a power of two.
void transform(std::vector<Complex>& values) {
    const std::size_t n = values.size();
    if (n == 1) return;
    std::vector<Complex> even(n / 2), odd(n / 2);
    for (std::size_t k = 0; k < n / 2; ++k) even[k] = values[2 * k], odd[k] = values[2 * k + 1];
    transform(even);
    transform(odd);
    for (std::size_t k = 0; k < n / 2; ++k) {
        const Complex turned =
            std::polar(1.0, -2.0 * std::numbers::pi * double(k) / double(n)) * odd[k];
        values[k] = even[k] + turned;
        values[k + n / 2] = even[k] - turned;
    }
}

constexpr std::size_t kCutSamples = 1u << 14;
constexpr double kCutLength = 64.0;  ///< in cells of the coarsest octave

/// Mean power by frequency (in 1 / kCutLength) over straight cuts in all directions.
std::vector<double> power_on_cuts(const Chaos& texture) {
    constexpr std::uint64_t kCuts = 12;
    std::vector<double> power(kCutSamples / 2);
    std::vector<Complex> cut(kCutSamples);
    for (std::uint64_t c = 0; c < kCuts; ++c) {
        const Vec3 start = point(c), along = direction(c);
        for (std::size_t k = 0; k < kCutSamples; ++k) {
            const double place = double(k) / double(kCutSamples);
            // Hann's window: what leaks from the strong end of the spectrum falls as f⁻⁶.
            const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * place);
            cut[k] = window * (chaos(start + along * (place * kCutLength), texture) - 0.5);
        }
        transform(cut);
        for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(cut[k]);
    }
    return power;
}

/// The exponent of f in the power from 2 to 64 cycles per coarsest cell: least squares in
/// logarithms, over half octaves. Ten octaves reach 512, so that both ends are clear of the range.
double slope_of(const Chaos& texture) {
    const std::vector<double> power = power_on_cuts(texture);
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (double low = 2.0; low < 63.0; low *= std::numbers::sqrt2) {
        const auto first = std::size_t(std::lround(low * kCutLength));
        const auto last = std::size_t(std::lround(low * std::numbers::sqrt2 * kCutLength));
        double mean = 0.0;
        for (std::size_t k = first; k < last; ++k) mean += power[k] / double(last - first);
        const double x = std::log(low), y = std::log(mean);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// The paper's statement. 12 cuts of 64 cells have a spread of 0.03 from seed to seed.
TEST(Chaos, HasAPowerSpectrumOneOverFSquaredOnCuts) {
    constexpr double kAllowed = 0.15;
    Chaos texture;
    texture.octaves = 10;
    EXPECT_NEAR(slope_of(texture), -2.0, kAllowed);
    texture.seed = 1;
    EXPECT_NEAR(slope_of(texture), -2.0, kAllowed);
    texture.exponent = 3.0;  // amplitudes 1/f
    EXPECT_NEAR(slope_of(texture), -3.0, kAllowed);
    texture.exponent = 2.0;
    texture.lacunarity = 2.7;
    texture.octaves = 7;  // to 2.7⁶ = 387
    EXPECT_NEAR(slope_of(texture), -2.0, kAllowed);
}

TEST(Chaos, HasItsMeanAndDeviation) {
    // 100,000 points hundreds of cells apart: standard errors 0.0005 and 0.0004; five of them. Cut
    // at three deviations a normal distribution loses 0.5 % of its deviation.
    constexpr double kMean = 0.0026, kDeviation = 0.003;
    for (const int octaves : {1, 8}) {
        Chaos texture;
        texture.octaves = octaves;
        double sum = 0.0, squares = 0.0;
        constexpr int kPoints = 100'000;
        for (std::uint64_t k = 0; k < kPoints; ++k) {
            const double value = chaos(point(k), texture);
            ASSERT_GE(value, 0.0);
            ASSERT_LE(value, 1.0);
            sum += value, squares += value * value;
        }
        const double mean = sum / kPoints;
        EXPECT_NEAR(mean, 0.5, kMean) << octaves;
        EXPECT_NEAR(std::sqrt(squares / kPoints - mean * mean), 1.0 / 6.0, kDeviation) << octaves;
    }
}

/// Root mean square of the derivative along `along`.
double steepness(const Chaos& texture, Vec3 along) {
    constexpr double kStep = 1e-5;
    double squares = 0.0;
    constexpr int kPoints = 20'000;
    for (std::uint64_t k = 0; k < kPoints; ++k) {
        const double rise = chaos(point(k) + along * kStep, texture) - chaos(point(k), texture);
        squares += rise * rise / (kStep * kStep);
    }
    return std::sqrt(squares / kPoints);
}

TEST(Chaos, IsStretchedAlongItsAxisAlone) {
    // 20,000 independent derivatives: 1 % of noise each.
    constexpr double kNoise = 0.05;
    const Vec3 axis = normalised({1.0, 4.0, 0.5});
    Chaos round, sheets;
    round.octaves = sheets.octaves = 2;
    sheets.axis = axis, sheets.stretch = 10.0;
    const Tangents across = tangents_of(axis);
    EXPECT_NEAR(steepness(sheets, axis) / steepness(round, axis), 0.1, 0.1 * kNoise);
    EXPECT_NEAR(steepness(sheets, across.t) / steepness(round, across.t), 1.0, kNoise);
    EXPECT_NEAR(steepness(sheets, across.b) / steepness(round, across.b), 1.0, kNoise);
}

TEST(Chaos, ScalesWithTheBaseFrequency) {
    constexpr double kRounding = 1e-12;
    Chaos coarse, fine;
    coarse.base_frequency = 1.0 / 256.0, fine.base_frequency = 1.0;
    for (std::uint64_t k = 0; k < 100; ++k)
        EXPECT_NEAR(chaos(point(k) * 256.0, coarse), chaos(point(k), fine), kRounding);
}

TEST(Chaos, IsContinuousAcrossCells) {
    Chaos texture;
    texture.octaves = 1;
    for (std::uint64_t k = 0; k < 1000; ++k) {
        // Less than 2⁻⁴⁰ · its steepest, which is below 4.
        constexpr double kStep = 0x1p-40, kMost = 4.0 * kStep;
        Vec3 p = point(k);
        p.x = std::floor(p.x) - 0.37;
        EXPECT_NEAR(chaos(p - Vec3{kStep, 0, 0}, texture), chaos(p + Vec3{kStep, 0, 0}, texture),
                    kMost);
    }
    const double here = chaos({0.25, 0.5, 0.75}, texture);
    EXPECT_EQ(chaos({0.25, 0.5, 0.75}, texture), here);
    texture.seed = 1;
    EXPECT_NE(chaos({0.25, 0.5, 0.75}, texture), here);
}

TEST(Chaos, IsAHalfWhereThereIsNoPlace) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(chaos({infinite, 0, 0}, {}), 0.5);
    EXPECT_EQ(chaos({0, std::nan(""), 0}, {}), 0.5);
    EXPECT_EQ(chaos({0, 1e300, 0}, {}), 0.5);
}

TEST(Chaos, DensityIsClamped) {
    Chaos texture;
    for (std::uint64_t k = 0; k < 100; ++k) {
        texture.bias = 0.25, texture.gain = 0.5;
        EXPECT_EQ(chaos_density(point(k), texture), 0.25 + 0.5 * chaos(point(k), texture));
        texture.bias = -3.0, texture.gain = 2.0;
        EXPECT_EQ(chaos_density(point(k), texture), 0.0);
        texture.bias = 2.0;
        EXPECT_EQ(chaos_density(point(k), texture), 1.0);
    }
}

}  // namespace
}  // namespace dewbow
