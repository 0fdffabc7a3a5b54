// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/sky_map.h"

#include <numeric>

#include "dewbow/render/equirectangular.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

/// Cells of 1.4°: the glow around a sun changes by less than a factor of two across one from 1° on.
/// The horizon lies between two rows.
constexpr int kColumns = 256, kRows = 128;
/// Of the mean: no direction is left out because its luminance is known to a few per cent only.
constexpr double kFloor = 0.01;

double brightness_from_luminance(double luminance) {
    return luminance / (kLuminousEfficacy * cie_y_integral());
}

/// Mean luminance of each cell, at four places within it, times its solid angle in units of that of
/// a cell at the horizon.
std::vector<double> cell_weights(const SkyDome& sky) {
    constexpr std::array<double, 2> kPlaces{0.25, 0.75};
    std::vector<double> weights;
    weights.reserve(std::size_t(kColumns) * kRows);
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            double sum = 0.0;
            for (const double v : kPlaces) {
                const double y = (row + v) / kRows;
                for (const double u : kPlaces)
                    sum +=
                        std::sin(std::numbers::pi * y) *
                        sky.luminance({direction_from_equirectangular((column + u) / kColumns, y)});
            }
            weights.push_back(0.25 * sum);
        }
    }
    return weights;
}

double row_sine(int row) { return std::sin(std::numbers::pi * (row + 0.5) / kRows); }

double sum_of_sines() {
    double sum = 0.0;
    for (int row = 0; row < kRows; ++row) sum += row_sine(row) * kColumns;
    return sum;
}

Distribution2D distribution_of(const SkyDome& sky) {
    std::vector<double> weights = cell_weights(sky);
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / sum_of_sines();
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] += kFloor * mean * row_sine(int(i) / kColumns);
    return Distribution2D(weights, kColumns, kRows);
}

}  // namespace

SkyMap::SkyMap(SkyDomePtr sky)
    : sky_(std::move(sky)),
      distribution_(distribution_of(*sky_)),
      mean_brightness_(
          brightness_from_luminance(distribution_.total() / ((1.0 + kFloor) * sum_of_sines()))) {}

std::optional<SkyMap::Sample> SkyMap::sample(std::array<double, 2> u) const {
    const Distribution2D::Sample s = distribution_.sample(u[0], u[1]);
    const double pdf = pdf_on_sphere(s.pdf, std::sin(std::numbers::pi * s.y));
    if (!(pdf > 0.0)) return std::nullopt;
    return Sample{direction_from_equirectangular(s.x, s.y), pdf};
}

double SkyMap::pdf(Vec3 direction) const {
    const EquirectangularPlace place = equirectangular_from_direction(direction);
    return pdf_on_sphere(distribution_.pdf(place.x, place.y), place.sin_theta);
}

std::array<double, 2> SkyMap::place_of(Vec3 direction) const {
    const EquirectangularPlace place = equirectangular_from_direction(direction);
    return distribution_.inverse(place.x, place.y);
}

double SkyMap::brightness(Vec3 direction) const {
    return brightness_from_luminance(sky_->luminance({direction}));
}

}  // namespace dewbow
