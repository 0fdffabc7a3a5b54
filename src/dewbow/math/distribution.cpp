// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/distribution.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dewbow/base/check.h"

namespace dewbow {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1

/// Largest weight. Sums are taken of weights over it, so that they neither overflow nor underflow.
double largest_of(std::span<const double> weights) {
    double largest = 0.0;
    for (const double w : weights) {
        DEWBOW_CHECK(w >= 0.0 && std::isfinite(w), "a weight is finite and not negative");
        largest = std::max(largest, w);
    }
    return largest;
}

std::vector<Distribution1D> distributions_of_rows(std::span<const double> weights,
                                                  std::size_t width, std::size_t height) {
    DEWBOW_CHECK(
        width > 0 && height > 0 && weights.size() / width == height && weights.size() % width == 0,
        "there is a weight for each cell");
    std::vector<Distribution1D> rows;
    rows.reserve(height);
    for (std::size_t y = 0; y < height; ++y) rows.emplace_back(weights.subspan(y * width, width));
    return rows;
}

std::vector<double> totals_of(std::span<const Distribution1D> rows) {
    std::vector<double> totals;
    totals.reserve(rows.size());
    for (const Distribution1D& row : rows) totals.push_back(row.total());
    return totals;
}

/// The cell of n equal cells of [0, 1) that holds x in [0, 1).
std::size_t cell_of(double x, std::size_t n) {
    return std::min(static_cast<std::size_t>(x * static_cast<double>(n)), n - 1);
}

double point_in_cell(std::size_t index, double offset, std::size_t n) {
    return std::min((static_cast<double>(index) + offset) / static_cast<double>(n), kOneBelow);
}

}  // namespace

Distribution1D::Distribution1D(std::span<const double> weights) : cdf_(weights.size() + 1) {
    DEWBOW_CHECK(!weights.empty(), "a distribution has a cell");
    const double largest = largest_of(weights);
    for (std::size_t i = 0; i < weights.size(); ++i)
        cdf_[i + 1] = cdf_[i] + (largest > 0.0 ? weights[i] / largest : 1.0);
    const double sum = cdf_.back();
    for (double& c : cdf_) c /= sum;
    total_ = largest * sum;
    const std::size_t parts = std::bit_floor(size());
    guide_.reserve(parts + 1);
    for (std::size_t part = 0, cell = 0; part <= parts; ++part) {
        const double low = static_cast<double>(part) / static_cast<double>(parts);
        while (cell + 1 < size() && cdf_[cell + 1] <= low) ++cell;
        guide_.push_back(static_cast<std::uint32_t>(cell));
    }
}

Distribution1D::Sample Distribution1D::sample(double u) const {
    u = std::clamp(u, 0.0, kOneBelow);
    // Exact: the number of parts is a power of two.
    const auto part = static_cast<std::size_t>(u * static_cast<double>(guide_.size() - 1));
    // The last cell that begins at or below u; one of no width begins where the next does.
    const double* first = cdf_.data() + guide_[part] + 1;
    const double* last = cdf_.data() + guide_[part + 1] + 1;
    const auto index = static_cast<std::size_t>(std::upper_bound(first, last, u) - cdf_.data()) - 1;
    const double offset = std::min((u - cdf_[index]) / probability(index), kOneBelow);
    return {index, offset, pdf(index)};
}

double Distribution1D::pdf(std::size_t index) const {
    return probability(index) * static_cast<double>(size());
}

double Distribution1D::cdf(double x) const {
    if (!(x > 0.0)) return 0.0;
    if (x >= 1.0) return 1.0;
    const std::size_t index = cell_of(x, size());
    const double offset = x * static_cast<double>(size()) - static_cast<double>(index);
    return cdf_[index] + offset * probability(index);
}

Distribution2D::Distribution2D(std::span<const double> weights, std::size_t width,
                               std::size_t height)
    : within_row_(distributions_of_rows(weights, width, height)), rows_(totals_of(within_row_)) {}

Distribution2D::Sample Distribution2D::sample(double u0, double u1) const {
    const Distribution1D::Sample row = rows_.sample(u1);
    const Distribution1D& within = within_row_[row.index];
    const Distribution1D::Sample cell = within.sample(u0);
    return {point_in_cell(cell.index, cell.offset, within.size()),
            point_in_cell(row.index, row.offset, rows_.size()), row.pdf * cell.pdf};
}

double Distribution2D::pdf(double x, double y) const {
    if (!(x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0)) return 0.0;
    const std::size_t row = cell_of(y, rows_.size());
    const Distribution1D& within = within_row_[row];
    return rows_.pdf(row) * within.pdf(cell_of(x, within.size()));
}

std::array<double, 2> Distribution2D::inverse(double x, double y) const {
    return {within_row_[cell_of(y, rows_.size())].cdf(x), rows_.cdf(y)};
}

}  // namespace dewbow
