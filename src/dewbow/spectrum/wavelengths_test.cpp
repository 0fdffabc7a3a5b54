// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/wavelengths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow {
namespace {

constexpr WavelengthSampling kBoth[] = {WavelengthSampling::visual, WavelengthSampling::uniform};
constexpr int kCounts[] = {1, 4, 8, 16};

/// ∫ pdf from 360 nm to `lambda_nm` (a multiple of 0.25), by Simpson's rule on quarters of a
/// nanometre.
double cumulative(WavelengthSampling sampling, double lambda_nm) {
    constexpr double kStep_nm = 0.25;
    double sum = 0.0;
    for (double a = kLambdaMin_nm; a < lambda_nm; a += kStep_nm) {
        sum += kStep_nm / 6.0 *
               (wavelength_pdf(sampling, a) + 4.0 * wavelength_pdf(sampling, a + 0.5 * kStep_nm) +
                wavelength_pdf(sampling, a + kStep_nm));
    }
    return sum;
}

TEST(Wavelengths, DensityIntegratesToOne) {
    constexpr double kRounding = 1e-12;
    for (auto sampling : kBoth) EXPECT_NEAR(cumulative(sampling, kLambdaMax_nm), 1.0, kRounding);
}

TEST(Wavelengths, DensityIsZeroOutsideAndNowhereElse) {
    for (auto sampling : kBoth) {
        EXPECT_EQ(wavelength_pdf(sampling, 359.99), 0.0);
        EXPECT_EQ(wavelength_pdf(sampling, 830.01), 0.0);
        EXPECT_EQ(wavelength_pdf(sampling, std::nan("")), 0.0);
        // No wavelength is starved: at least 9 % of the lanes are spread evenly.
        for (double l = 360.0; l <= 830.0; l += 0.5)
            EXPECT_GT(wavelength_pdf(sampling, l), 0.08 / 470);
    }
}

TEST(Wavelengths, SamplingInvertsTheIntegralOfTheDensity) {
    // Where the density is least (1.9e-4 per nm), a rounding of 1e-13 in the integral moves this
    // far.
    constexpr double kTolerance_nm = 1e-8;
    for (auto sampling : kBoth) {
        for (double lambda_nm = 360.25; lambda_nm < 829.9; lambda_nm += 3.25) {
            const double u = cumulative(sampling, lambda_nm);
            const WavelengthPacket packet = sample_wavelengths(sampling, 1, u);
            EXPECT_NEAR(packet.lambda_nm[0], lambda_nm, kTolerance_nm) << u;
        }
    }
}

TEST(Wavelengths, PacketsCarryTheDensityToTheLastBit) {
    for (auto sampling : kBoth) {
        for (int i = 0; i < 1000; ++i) {
            const WavelengthPacket packet = sample_wavelengths(sampling, 16, i / 1000.0);
            for (int k = 0; k < 16; ++k) {
                EXPECT_EQ(packet.pdf_per_nm[k], wavelength_pdf(sampling, packet.lambda_nm[k]));
            }
        }
    }
}

TEST(Wavelengths, LanesAreStratifiedAndTurnTogether) {
    for (int count : kCounts) {
        const double u = 0.77;
        const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::uniform, count, u);
        ASSERT_EQ(packet.count, count);
        for (int k = 0; k < count; ++k) {
            const double quantile = std::fmod(u + double(k) / count, 1.0);
            EXPECT_NEAR(packet.lambda_nm[k], 360.0 + 470.0 * quantile, 1e-10);
        }
    }
}

TEST(Wavelengths, TheEndsOfTheRangeAreReachedAndNotLeft) {
    for (auto sampling : kBoth) {
        EXPECT_EQ(sample_wavelengths(sampling, 1, 0.0).lambda_nm[0], 360.0);
        const double last = std::nextafter(1.0, 0.0);
        const WavelengthPacket packet = sample_wavelengths(sampling, 1, last);
        EXPECT_NEAR(packet.lambda_nm[0], 830.0, 1e-9);
        EXPECT_LE(packet.lambda_nm[0], 830.0);
        EXPECT_GT(packet.pdf_per_nm[0], 0.0);
    }
}

/// X, Y, Z of packets of a light over evenly spaced rotations: mean, and standard deviation over
/// mean.
struct PacketStatistics {
    std::array<double, 3> mean{}, relative_sd{};
};
PacketStatistics statistics(WavelengthSampling sampling, int count, const Spectrum& light,
                            double planted_pdf_factor = 1.0) {
    constexpr int kRotations = 4096;
    std::array<double, 3> sum{}, squares{};
    for (int i = 0; i < kRotations; ++i) {
        auto packet = sample_wavelengths(sampling, count, (i + 0.5) / kRotations);
        for (double& pdf : packet.pdf_per_nm) pdf *= planted_pdf_factor;
        std::array<double, kMaxLanes> values{};
        light.eval_lanes(packet.lambdas(), {values.data(), std::size_t(count)});
        const auto xyz = xyz_from_lanes(packet, {values.data(), std::size_t(count)});
        for (std::size_t c = 0; c < 3; ++c) sum[c] += xyz[c], squares[c] += xyz[c] * xyz[c];
    }
    PacketStatistics result;
    for (std::size_t c = 0; c < 3; ++c) {
        result.mean[c] = sum[c] / kRotations;
        const double variance = squares[c] / kRotations - result.mean[c] * result.mean[c];
        result.relative_sd[c] = std::sqrt(std::max(0.0, variance)) / result.mean[c];
    }
    return result;
}

/// Largest relative difference of the mean packet from the integral over the spectrum.
double bias(WavelengthSampling sampling, int count, const Spectrum& light, double planted = 1.0) {
    const auto mean = statistics(sampling, count, light, planted).mean;
    const auto expected = xyz_from_spectrum(light);
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(mean[c] / expected[c] - 1.0));
    }
    return largest;
}

/// Two quadratures, neither exact: 4096 rotations, and the trapezoid rule at 0.5 nm, which errs by
/// 3e-6 in the Z of D65.
constexpr double kQuadrature = 1e-5;

TEST(Packets, AverageToTheIntegral) {
    for (auto sampling : kBoth) {
        for (int count : kCounts) {
            EXPECT_LT(bias(sampling, count, *make_constant(1.0)), kQuadrature) << count;
            EXPECT_LT(bias(sampling, count, *find_illuminant("D65")), kQuadrature) << count;
        }
    }
}

TEST(Packets, AWrongDensityWouldBeSeen) {
    constexpr double kPlanted = 1.0001;
    for (int count : kCounts) {
        EXPECT_GT(bias(WavelengthSampling::visual, count, *make_constant(1.0), kPlanted),
                  kQuadrature);
    }
}

TEST(Packets, AreNearlyWhiteOneByOne) {
    // Measured: 8 lanes .0168 .0120 .0170, 16 lanes .0044 .0021 .0038.
    const SpectrumPtr white = make_constant(1.0);
    for (double sd : statistics(WavelengthSampling::visual, 8, *white).relative_sd)
        EXPECT_LT(sd, 0.018);
    for (double sd : statistics(WavelengthSampling::visual, 16, *white).relative_sd)
        EXPECT_LT(sd, 0.005);
}

TEST(PacketsDeathTest, HaveOneFourEightOrSixteenLanes) {
    EXPECT_DEATH(sample_wavelengths(WavelengthSampling::visual, 5, 0.5), "lanes");
    EXPECT_DEATH(sample_wavelengths(WavelengthSampling::visual, 8, 1.0), "rotation");
}

}  // namespace
}  // namespace dewbow
