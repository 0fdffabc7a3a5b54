// SPDX-License-Identifier: Apache-2.0
#include "aliasing/eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

constexpr Matrix3 kOpponentFromXyz{
    {{Triple{0.2787336, 0.7218031, -0.1065520},     // light and dark
      Triple{-0.4487736, 0.2898056, 0.0771569},     // red and green
      Triple{0.0859513, -0.5899859, 0.5011089}}}};  // blue and yellow
constexpr Matrix3 kXyzFromOpponent = inverse(kOpponentFromXyz);

/// The published lobes are w exp(-r²/s²), s in degrees; their weights do not sum to 1. Black–white
/// has a third, -0.108 and 4.336°, which would make light next to a wide source negative: left out.
constexpr Lobe lobe(double weight, double sum, double s_deg) {
    return {weight / sum, 60.0 * s_deg / std::numbers::sqrt2};
}
constexpr std::array<Lobe, 2> kLuminance{lobe(0.921, 1.026, 0.0283), lobe(0.105, 1.026, 0.133)};
constexpr std::array<Lobe, 2> kRedGreen{lobe(0.531, 0.861, 0.0392), lobe(0.330, 0.861, 0.494)};
constexpr std::array<Lobe, 2> kBlueYellow{lobe(0.488, 0.859, 0.0536), lobe(0.371, 0.859, 0.386)};

/// Share of a Gaussian that falls on a pixel `step` pixels aside.
double share_of_pixel(double sigma, double pixel, int step) {
    const double scale = 1.0 / (std::numbers::sqrt2 * sigma);
    return 0.5 * (std::erf((step + 0.5) * pixel * scale) - std::erf((step - 0.5) * pixel * scale));
}

/// Σ over pixels of the shares of two Gaussians around the middle of one.
double shared_weight(double sigma_a, double sigma_b, double pixel) {
    const int reach = int(std::ceil(5.0 * std::min(sigma_a, sigma_b) / pixel)) + 1;
    double along = 0.0;
    for (int step = -reach; step <= reach; ++step)
        along += share_of_pixel(sigma_a, pixel, step) * share_of_pixel(sigma_b, pixel, step);
    return along * along;
}

/// Columns whose outer products sum to a covariance, also to one without full rank.   [Cholesky]
std::array<Triple, 3> columns_of(Matrix3 covariance) {
    std::array<Triple, 3> columns{};
    for (std::size_t c = 0; c < 3; ++c) {
        if (covariance[c][c] <= 0.0) continue;
        for (std::size_t r = 0; r < 3; ++r)
            columns[c][r] = covariance[r][c] / std::sqrt(covariance[c][c]);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) covariance[i][j] -= columns[c][i] * columns[c][j];
    }
    return columns;
}

}  // namespace

Colour<Opponent> opponent_from_xyz(Colour<Xyz> xyz) { return {kOpponentFromXyz * xyz.v}; }

std::span<const Lobe> lobes(std::size_t channel) {
    if (channel == 0) return kLuminance;
    if (channel == 1) return kRedGreen;
    return kBlueYellow;
}

double sharpest_arcmin() { return kLuminance[0].sigma_arcmin; }

double visible_difference(Colour<Opponent> a, Colour<Opponent> b) {
    static const Colour<Xyz> white = xyz_from_rgb(Colour<LinearSrgb>{{1.0, 1.0, 1.0}});
    const auto veiled = [](Colour<Opponent> x) {
        return (1.0 - kFlare) * Colour<Xyz>{kXyzFromOpponent * x.v} + kFlare * white;
    };
    return delta_e_2000(veiled(a), veiled(b), white);
}

Matrix3 seen_covariance(const Matrix3& of_pixel, double pixel_arcmin) {
    Matrix3 seen;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (const Lobe& a : lobes(i))
                for (const Lobe& b : lobes(j))
                    seen[i][j] += of_pixel[i][j] * a.weight * b.weight *
                                  shared_weight(a.sigma_arcmin, b.sigma_arcmin, pixel_arcmin);
    return seen;
}

double rms_difference(Colour<Opponent> mean, const Matrix3& covariance) {
    double squares = 0.0;
    for (const Triple& column : columns_of(covariance)) {
        const double step = visible_difference(mean, mean + Colour<Opponent>{column});
        squares += step * step;
    }
    return std::sqrt(squares);
}

}  // namespace dewbow::bench
