// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whether samples of directions are distributed as their density says: χ² on the sphere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "../analytic/scene_kit.h"

namespace dewbow::kit {

inline constexpr int kSamples = 1000000;
inline constexpr int kRows = 24, kColumns = 24;
/// Midpoints a side of a cell over which densities are integrated.
inline constexpr int kFine = 32;
/// Cells that expect fewer samples are pooled.
inline constexpr double kLeastExpected = 10.0;
/// (χ² − ν) / √(2ν) with some hundred degrees of freedom: about 1e-6.
inline constexpr double kChiLimit = 5.2;
/// Midpoints integrate the densities here to this, by halving the cells.
inline constexpr double kQuadrature = 2e-3;

using SampleDirection = std::function<std::optional<Vec3>(const SampleKey&)>;
using Density = std::function<double(Vec3)>;

struct ChiSquare {
    double score;     // (χ² − ν) / √(2ν)
    double integral;  // of the density over the sphere
    bool in_void;     // a sample where the density is 0
};

/// χ² of samples in cells of equal solid angle, the failed samples as one more cell.
/// @param quadrature  share of a cell's expectation that midpoints may miss.
inline ChiSquare chi_square(const SampleDirection& sample, const Density& density,
                            int samples = kSamples, double quadrature = kQuadrature) {
    std::vector<double> expected(kRows * kColumns), found(kRows * kColumns, 0.0);
    ChiSquare result{0.0, 0.0, false};
    const double cell = 4.0 * kPi / double(kRows * kColumns);
    for (int i = 0; i < kRows * kColumns; ++i) {
        double sum = 0.0;
        for (int a = 0; a < kFine * kFine; ++a) {
            const double z = 1.0 - 2.0 * (i / kColumns + (a / kFine + 0.5) / kFine) / kRows;
            const double phi = 2.0 * kPi * (i % kColumns + (a % kFine + 0.5) / kFine) / kColumns;
            const double s = std::sqrt(1.0 - z * z);
            sum += density({s * std::cos(phi), s * std::sin(phi), z});
        }
        expected[std::size_t(i)] = sum / (kFine * kFine) * cell * samples;
        result.integral += expected[std::size_t(i)] / samples;
    }
    double failed = 0.0;
    for (int i = 0; i < samples; ++i) {
        const std::optional<Vec3> d = sample(independent_key(30, std::size_t(i)));
        if (!d) {
            failed += 1.0;
            continue;
        }
        double turn = std::atan2(d->y, d->x) / (2.0 * kPi);
        if (turn < 0.0) turn += 1.0;
        const int row = std::clamp(int(0.5 * (1.0 - d->z) * kRows), 0, kRows - 1);
        found[std::size_t(row * kColumns + std::min(kColumns - 1, int(turn * kColumns)))] += 1.0;
        result.in_void = result.in_void || !(density(*d) > 0.0);
    }
    double chi = 0.0, pooled_expected = samples * std::max(0.0, 1.0 - result.integral),
           pooled_found = failed;
    int freedom = -1;
    // The quadrature's own error, in samples, counts as variance.
    const auto take = [&](double e, double f, double missed) {
        chi += (f - e) * (f - e) / (e + missed * missed);
        ++freedom;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= kLeastExpected)
            take(expected[i], found[i], quadrature * expected[i]);
        else
            pooled_expected += expected[i], pooled_found += found[i];
    }
    take(std::max(kLeastExpected, pooled_expected), std::max(kLeastExpected, pooled_found),
         quadrature * samples);
    result.score = (chi - freedom) / std::sqrt(2.0 * freedom);
    return result;
}

inline void expect_good(const SampleDirection& sample, const Density& density, bool whole) {
    const ChiSquare found = chi_square(sample, density);
    EXPECT_LT(found.score, kChiLimit);
    EXPECT_FALSE(found.in_void);
    EXPECT_LE(found.integral, 1.0 + kQuadrature);
    if (whole) {
        EXPECT_NEAR(found.integral, 1.0, kQuadrature);
    }
}

inline Vec3 tilted(double cosine) { return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}; }

}  // namespace dewbow::kit
