// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/diffuse_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/parallel.h"
#include "dewbow/math/interpolation.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kLevels = kDiffuseLevels / 2, kAltitudes = 37, kAzimuths = 37;

/// The last knot is the top of the air.
double level_m(int level) {
    const double v = static_cast<double>(level) / (kLevels - 1);
    return kSkyTop_m * v * v * v;
}

std::size_t knot_of(int level, int altitude, int azimuth) {
    return (static_cast<std::size_t>(level) * kAltitudes + altitude) * kAzimuths + azimuth;
}

/// What a phase function makes of moments, by azimuthal mode.
using Modes = std::array<double, kDiffuseDegree + 1>;
Modes modes_of(const PhaseMoments& phase, const Harmonics& moments, const Harmonics& direction) {
    Modes modes{};
    std::size_t n = 0;
    for (int m = 0; m <= kDiffuseDegree; ++m)
        for (int l = m; l <= kDiffuseDegree; ++l, ++n)
            modes[m] += phase[l] * moments[n] * direction[n];
    return modes;
}
float sum_of(const Modes& modes, const Modes& cosines) {
    double sum = 0.0;
    for (int m = 0; m <= kDiffuseDegree; ++m) sum += modes[m] * cosines[m];
    return static_cast<float>(std::max(sum, 0.0));
}

}  // namespace

DiffuseSource::DiffuseSource(const ClearDay& day) : rows_(knot_of(kLevels, 0, 0)) {
    const PhaseMoments air = air_phase_moments(), haze = haze_phase_moments(day.asymmetry);
    std::array<Harmonics, kAltitudes> directions;
    for (int i = 0; i < kAltitudes; ++i)
        legendre_harmonics(kDiffuseDegree, std::sin(kPi * i / (kAltitudes - 1) - 0.5 * kPi),
                           directions[i]);
    std::array<Modes, kAzimuths> cosines;
    for (int j = 0; j < kAzimuths; ++j)
        for (int m = 0; m <= kDiffuseDegree; ++m)
            cosines[j][m] = std::cos(m * kPi * j / (kAzimuths - 1));
    parallel_for(kLevels, [&](std::size_t at) {
        const int level = static_cast<int>(at);
        for (int k = 0; k < kSkyWavelengths; ++k) {
            const Harmonics moments = day.diffuse[k].at(level_m(level));
            for (int i = 0; i < kAltitudes; ++i) {
                const Modes by_air = modes_of(air, moments, directions[i]);
                const Modes by_haze = modes_of(haze, moments, directions[i]);
                for (int j = 0; j < kAzimuths; ++j) {
                    rows_[knot_of(level, i, j)][k] = {sum_of(by_air, cosines[j]),
                                                      sum_of(by_haze, cosines[j])};
                }
            }
        }
    });
}

DiffuseSource::Row DiffuseSource::at(double height_m, double sine, double azimuth) const {
    const auto [level, tl] =
        knot_interval(std::cbrt(height_m / kSkyTop_m) * (kLevels - 1), kLevels);
    const double altitude = std::asin(std::clamp(sine, -1.0, 1.0));
    const auto [i, ti] = knot_interval((altitude / kPi + 0.5) * (kAltitudes - 1), kAltitudes);
    const auto [j, tj] = knot_interval(azimuth / kPi * (kAzimuths - 1), kAzimuths);
    Row sum{};
    for (int c = 0; c < 8; ++c) {
        const int dl = c >> 2, di = (c >> 1) & 1, dj = c & 1;
        const float weight =
            static_cast<float>((dl ? tl : 1.0 - tl) * (di ? ti : 1.0 - ti) * (dj ? tj : 1.0 - tj));
        const Row& row = rows_[knot_of(level + dl, i + di, j + dj)];
        for (int k = 0; k < kSkyWavelengths; ++k) {
            sum[k].air += weight * row[k].air;
            sum[k].haze += weight * row[k].haze;
        }
    }
    return sum;
}

}  // namespace dewbow
