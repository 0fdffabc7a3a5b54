// SPDX-License-Identifier: Apache-2.0

// A plane-parallel plate of coloured, dispersive glass in even light: what it reflects and lets
// through adds up to R + (1 − R)² a / (1 − R a), a = exp(−σ d / cos θ_t), by wavelength.

#include <gtest/gtest.h>

#include "scene_kit.h"
#include "statistics.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr double kThickness_m = 0.01;
/// Wide enough that no path reaches the rim: it moves by less than 4 cm a reflection, and after 40
/// of them light is below 1e-15.
constexpr double kSide_m = 10.0;
constexpr int kBins = 12;
constexpr std::array<double, 4> kAngles_deg{0.0, 30.0, 60.0, 85.0};
/// Two-sided 1e-8 for one z: 1e-6 for the 96 of this file together.
constexpr double kSigmas = 5.73;
/// An error of this much in any bin is found with probability 0.99; else the test calls itself too
/// weak.
constexpr double kDetectable = 0.02;

SpectrumPtr absorption() {  // m⁻¹: from nearly clear to nearly black at 1 cm
    return make_tabulated({360, 450, 520, 600, 700, 830}, {20, 250, 90, 5, 60, 150},
                          OutsideTable::hold);
}

/// Fresnel by angles: not the way in which the renderer has it.
double reflectance(double theta_i, double theta_t, double n) {
    if (theta_i == 0.0) return std::pow((n - 1.0) / (n + 1.0), 2.0);
    const double s = std::sin(theta_i - theta_t) / std::sin(theta_i + theta_t);
    const double p = std::tan(theta_i - theta_t) / std::tan(theta_i + theta_t);
    return 0.5 * (s * s + p * p);
}

using Expected = double (*)(double theta_i, double n, double sigma);
double expected(double theta_i, double n, double sigma) {
    const double theta_t = std::asin(std::sin(theta_i) / n);
    const double r = reflectance(theta_i, theta_t, n);
    const double a = std::exp(-sigma * kThickness_m / std::cos(theta_t));
    return r + (1.0 - r) * (1.0 - r) * a / (1.0 - r * a);
}

/// Largest |z| over the bins of all wavelengths, and the smallest error that can be found.
struct Verdict {
    double z = 0.0, detectable = 0.0;
};
Verdict compare(double angle_deg, int packet, std::size_t samples, Expected formula) {
    Scene scene = furnace_scene();
    const MediumPtr flint = glass("schott/N-SF11", absorption());
    const Affine askew = rotation(normalised({1, 2, 3}), 40.0 * deg);
    add(scene, Box{kSide_m * m, kThickness_m * m, kSide_m * m}, dielectric(flint), askew);
    const PreparedScene prepared(scene);
    const double theta = angle_deg * kPi / 180.0;
    const Vec3 direction = normalised(
        askew.apply_linear({std::sin(theta) * 0.6, -std::cos(theta), std::sin(theta) * 0.8}));
    const Ray ray{-1.0 * direction, direction, {}};
    constexpr std::size_t kChunks = 64;
    std::vector<std::array<MeanSums, kBins>> parts(kChunks);
    in_chunks(samples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const SampleKey key = independent_key(std::uint64_t(angle_deg) + 100, i);
            const WavelengthPacket lanes = packet_of(key, packet, WavelengthSampling::uniform);
            const PixelSample sample = trace_sample(prepared, ray, {}, lanes, key);
            for (std::size_t k = 0; k < std::size_t(packet); ++k) {
                const double lambda = lanes.lambda_nm[k];
                const double value = formula(theta, index_of(*flint, lambda),
                                             (*flint->absorption)(lambda * unit::nm));
                const int bin = std::min(kBins - 1, int(kBins * (lambda - kLambdaMin_nm) / 470.0));
                parts[chunk][std::size_t(bin)].add(sample.radiance[k] - value);
            }
        }
    });
    Verdict verdict;
    for (int bin = 0; bin < kBins; ++bin) {
        MeanSums all;
        for (const auto& part : parts) all.add(part[std::size_t(bin)]);
        verdict.z = std::max(verdict.z, std::abs(all.z()));
        verdict.detectable =
            std::max(verdict.detectable, (kSigmas + kPower99) * all.standard_error());
    }
    return verdict;
}

TEST(AbsorbingSlab, IsTheSumOfItsReflections) {
    for (const double angle : kAngles_deg) {
        for (const int packet : {1, 8}) {
            const Verdict verdict =
                compare(angle, packet, packet == 1 ? 800000 : 100000, &expected);
            EXPECT_LT(verdict.z, kSigmas) << angle << "°, packet " << packet;
            EXPECT_LT(verdict.detectable, kDetectable) << angle << "°, packet " << packet;
            std::printf("    %2.0f deg, packet %d: largest of %d |z| %.2f, detectable %.4f\n",
                        angle, packet, kBins, verdict.z, verdict.detectable);
        }
    }
}

TEST(AbsorbingSlab, SeesPlantedErrors) {
    // The way through the plate without 1 / cos θ_t: 20 % of σ at 60°.
    const auto straight = [](double theta_i, double n, double sigma) {
        return expected(theta_i, n, sigma * std::cos(std::asin(std::sin(theta_i) / n)));
    };
    EXPECT_GT(compare(60.0, 8, 100000, straight).z, kSigmas);
    // The light that goes to and fro inside left out.
    const auto once = [](double theta_i, double n, double sigma) {
        const double theta_t = std::asin(std::sin(theta_i) / n);
        const double r = reflectance(theta_i, theta_t, n);
        return r + (1.0 - r) * (1.0 - r) * std::exp(-sigma * kThickness_m / std::cos(theta_t));
    };
    EXPECT_GT(compare(60.0, 8, 100000, once).z, kSigmas);
    // σ of the wavelength 3 nm beside.
    const auto beside = [](double theta_i, double n, double sigma) {
        return expected(theta_i, n, sigma + 3.0);
    };
    EXPECT_GT(compare(30.0, 8, 100000, beside).z, kSigmas);
}

}  // namespace
}  // namespace dewbow
