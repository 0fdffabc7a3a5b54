// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sky_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/check.h"
#include "dewbow/math/interpolation.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// Catmull & Rom's weights of the knots −1, 0, 1, 2 at t in [0, 1].
std::array<double, 4> cubic_weights(double t) {
    const double u = 1.0 - t;
    return {-0.5 * t * u * u, 1.0 + t * t * (1.5 * t - 2.5), 1.0 + u * u * (1.5 * u - 2.5),
            -0.5 * u * t * t};
}

/// Beyond its ends azimuth is mirrored about the sun's meridian.
int mirrored(int j) {
    const int last = kSkyAzimuths - 1;
    return j < 0 ? -j : j > last ? 2 * last - j : j;
}

}  // namespace

double sky_angle(int i, double reach) {
    const double u = static_cast<double>(i) / (kSkyElevations - 1);
    return reach * u * u;
}
double sky_azimuth(int j) { return kPi * j / (kSkyAzimuths - 1); }
double sky_wavelength_nm(int k) {
    return kLambdaMin_nm + (kLambdaMax_nm - kLambdaMin_nm) * k / (kSkyWavelengths - 1);
}

SkyStencil::SkyStencil(double share, double azimuth) {
    const double u = std::sqrt(std::clamp(share, 0.0, 1.0));
    const auto [row, tr] = knot_interval(u * (kSkyElevations - 1), kSkyElevations);
    const auto [column, tc] = knot_interval(azimuth / kPi * (kSkyAzimuths - 1), kSkyAzimuths);
    const auto wr = cubic_weights(tr), wc = cubic_weights(tc);
    for (int a = 0; a < 4; ++a) {
        // Beyond the horizon knots are mirrored: values are even in the root of the angle. Beyond
        // the zenith lies the other side.
        int i = std::abs(row + a - 1);
        const bool over = i > kSkyElevations - 1;
        if (over) i = 2 * (kSkyElevations - 1) - i;
        for (int b = 0; b < 4; ++b) {
            int j = mirrored(column + b - 1);
            if (over) j = kSkyAzimuths - 1 - j;
            knots[4 * a + b] = static_cast<std::size_t>(i) * kSkyAzimuths + j;
            weights[4 * a + b] = wr[a] * wc[b];
        }
    }
}

std::vector<double> refine_over_wavelength(std::span<const double> values) {
    constexpr double kLeast = 1e-30;
    const int n = static_cast<int>(values.size());
    const auto log_at = [&](int k) { return std::log(std::max(values[k], kLeast)); };
    std::vector<double> fine(SkyTable::kFineWavelengths);
    for (int f = 0; f < SkyTable::kFineWavelengths; ++f) {
        const auto [first, t] = knot_interval(f * (n - 1.0) / (SkyTable::kFineWavelengths - 1), n);
        const auto w = cubic_weights(t);
        const double before = first > 0 ? log_at(first - 1) : 2.0 * log_at(0) - log_at(1);
        const double after =
            first + 2 < n ? log_at(first + 2) : 2.0 * log_at(n - 1) - log_at(n - 2);
        fine[f] = std::exp(w[0] * before + w[1] * log_at(first) + w[2] * log_at(first + 1) +
                           w[3] * after);
    }
    return fine;
}

SkyTable::SkyTable(std::span<const double> values) {
    DEWBOW_CHECK(values.size() == std::size_t{kSkyElevations} * kSkyAzimuths * kSkyWavelengths,
                 "one value for each knot");
    values_.reserve(std::size_t{kSkyElevations} * kSkyAzimuths * kFineWavelengths);
    for (std::size_t at = 0; at < values.size(); at += kSkyWavelengths)
        for (const double v : refine_over_wavelength(values.subspan(at, kSkyWavelengths)))
            values_.push_back(static_cast<float>(v));
}

void SkyTable::eval_lanes(double share, double azimuth, std::span<const double> lambda_nm,
                          std::span<double> out) const {
    const SkyStencil stencil(share, azimuth);
    std::fill(out.begin(), out.end(), 0.0);
    for (int k = 0; k < 16; ++k) {
        const float* row = &values_[stencil.knots[k] * kFineWavelengths];
        for (std::size_t lane = 0; lane < out.size(); ++lane) {
            const auto [first, t] =
                knot_interval((lambda_nm[lane] - kLambdaMin_nm) / kFineStep_nm, kFineWavelengths);
            out[lane] += stencil.weights[k] * (row[first] + t * (row[first + 1] - row[first]));
        }
    }
    for (double& value : out) value = std::max(value, 0.0);
}

std::vector<double> SkyTable::weighted_sum(std::span<const double> fine_weights) const {
    std::vector<double> sums(std::size_t{kSkyElevations} * kSkyAzimuths);
    for (std::size_t knot = 0; knot < sums.size(); ++knot)
        for (int f = 0; f < kFineWavelengths; ++f)
            sums[knot] += fine_weights[f] * values_[knot * kFineWavelengths + f];
    return sums;
}

}  // namespace dewbow
