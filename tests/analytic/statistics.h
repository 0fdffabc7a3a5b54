// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tests of hypotheses about means. Seeds are fixed, so that a test's outcome is a property of the
// code: a false alarm can only come with a change of the code, and each rate below is the chance of
// one for such a change.

#include <array>
#include <cmath>
#include <cstddef>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/matrix3.h"

namespace dewbow::kit {

/// χ² with 3 degrees of freedom exceeds this with probability 1e-5.
inline constexpr double kChi3At1em5 = 25.90;
/// With this noncentrality χ²₃ exceeds kChi3At1em5 with probability 0.99: (√25.9 + 2.33)², which is
/// on the safe side of the exact 52.6.
inline constexpr double kChi3Noncentrality = 55.0;
/// The same for 1e-6, where a test compares many scenes.
inline constexpr double kChi3At1em6 = 30.66;
/// Quantile of the normal distribution to which a power of 0.99 adds.
inline constexpr double kPower99 = 2.33;

/// Mean of numbers, and its error. The numbers are to be near 0: subtract what is expected.
struct MeanSums {
    double n = 0.0, sum = 0.0, squares = 0.0;

    void add(double x) { n += 1.0, sum += x, squares += x * x; }
    void add(const MeanSums& b) { n += b.n, sum += b.sum, squares += b.squares; }
    double mean() const { return sum / n; }
    double standard_error() const {
        return std::sqrt(std::max(0.0, squares / n - mean() * mean()) / (n - 1.0));
    }
    double z() const { return mean() / standard_error(); }
};

/// Mean of vectors, and its covariance. The vectors are to be near 0: subtract what is expected.
struct VectorSums {
    double n = 0.0;
    Triple sum{};
    Matrix3 squares;

    void add(const Triple& x) {
        n += 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += x[i];
            for (std::size_t j = 0; j < 3; ++j) squares[i][j] += x[i] * x[j];
        }
    }
    void add(const VectorSums& b) {
        n += b.n;
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += b.sum[i];
            for (std::size_t j = 0; j < 3; ++j) squares[i][j] += b.squares[i][j];
        }
    }
    Triple mean() const { return {sum[0] / n, sum[1] / n, sum[2] / n}; }
    Matrix3 covariance_of_mean() const {
        const Triple at = mean();
        Matrix3 result;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                result[i][j] = (squares[i][j] / n - at[i] * at[j]) / (n - 1.0);
        return result;
    }
};

/// Hotelling's T² of a mean against zero. With many samples it is χ² with 3 degrees of freedom.
inline double hotelling(const Triple& mean, const Matrix3& covariance_of_mean) {
    return dot(mean, inverse(covariance_of_mean) * mean);
}
inline double hotelling(const VectorSums& a) { return hotelling(a.mean(), a.covariance_of_mean()); }
/// Of the difference of two means with their own covariances (Welch's form).
inline double hotelling(const VectorSums& a, const VectorSums& b) {
    const Triple ma = a.mean(), mb = b.mean();
    Matrix3 both = a.covariance_of_mean();
    const Matrix3 other = b.covariance_of_mean();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) both[i][j] += other[i][j];
    return hotelling(Triple{ma[0] - mb[0], ma[1] - mb[1], ma[2] - mb[2]}, both);
}

/// The error of all of X, Y, Z in the same proportion that a T²-test at kChi3At1em5 finds with
/// probability 0.99 or more. Bounded by Y alone: μᵀS⁻¹μ >= μ_Y² / S_YY.
inline double detectable_share(double variance_of_mean_y, double y) {
    return std::sqrt(kChi3Noncentrality * variance_of_mean_y) / y;
}

}  // namespace dewbow::kit
