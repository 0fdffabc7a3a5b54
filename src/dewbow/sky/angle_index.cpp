// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/angle_index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

/// 0.05°: most bins meet one or two cells of a table for rain; those near 180° a hundred.
constexpr std::size_t kBins = 3600;
constexpr double kBinsPerRadian = kBins / std::numbers::pi;

std::size_t bin_of(double radians) {
    return std::min(static_cast<std::size_t>(radians * kBinsPerRadian), kBins - 1);
}

}  // namespace

AngleIndex::AngleIndex(std::span<const Angle> angles) {
    for (const Angle angle : angles) {
        radians_.push_back(angle.to(unit::rad));
        cosines_.push_back(std::cos(radians_.back()));
    }
    radians_.back() = std::numbers::pi;
    cosines_.back() = -1.0;
    std::size_t cell = 0;
    for (std::size_t bin = 0; bin <= kBins; ++bin) {
        while (cell + 1 < cells() && bin_of(radians_[cell + 1]) < bin) ++cell;
        first_cell_.push_back(static_cast<std::uint32_t>(cell));
    }
}

AngleIndex::Place AngleIndex::find(double cosine) const {
    const double theta = std::acos(std::clamp(cosine, -1.0, 1.0));
    const std::size_t bin = bin_of(theta);
    const auto begin = radians_.begin();
    // The cell's upper end lies above theta, and no further than the first one of the next bin.
    const auto low = begin + first_cell_[bin] + 1;
    const auto high = begin + std::ptrdiff_t(std::min<std::size_t>(first_cell_[bin + 1] + 2,
                                                                   radians_.size() - 1));
    const auto above = std::upper_bound(low, high, theta);
    const std::size_t cell = static_cast<std::size_t>(above - begin) - 1;
    const double from = radians_[cell], to = radians_[cell + 1];
    return {cell, std::clamp((theta - from) / (to - from), 0.0, 1.0)};
}

}  // namespace dewbow
