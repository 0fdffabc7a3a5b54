// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/pixel_filter.h"

#include <numbers>

namespace dewbow {

namespace {

/// Cells of the table of a filter: its steps are 1/500 of the filter's width, far below what shows.
constexpr int kFilterCells = 500;

/// The filter at x in [−1, 1], unnormalised.
double filter_value(FilterKind kind, double x) {
    switch (kind) {
        case FilterKind::box:
            return 1.0;
        case FilterKind::gaussian:
            return std::exp(-0.5 * 9.0 * x * x);
        case FilterKind::blackman_harris: {
            // The four-term window. [Harris 1978, table 1: minimum side lobes, −92 dB]
            const double a = std::numbers::pi * (x + 1.0);
            return 0.35875 - 0.48829 * std::cos(a) + 0.14128 * std::cos(2.0 * a) -
                   0.01168 * std::cos(3.0 * a);
        }
    }
    return 0.0;
}

std::vector<double> filter_table(FilterKind kind) {
    std::vector<double> table;
    for (int i = 0; i < kFilterCells; ++i)
        table.push_back(filter_value(kind, 2.0 * (i + 0.5) / kFilterCells - 1.0));
    return table;
}

}  // namespace

FilterSampler::FilterSampler(const PixelFilter& filter)
    : radius_(filter.radius), table_(filter_table(filter.kind)) {}

double FilterSampler::sample(double u) const {
    const Distribution1D::Sample s = table_.sample(u);
    return radius_ * (2.0 * (double(s.index) + s.offset) / kFilterCells - 1.0);
}

double FilterSampler::density(double offset) const {
    const double cell = 0.5 * kFilterCells * (1.0 + offset / radius_);
    if (!(cell >= 0.0 && cell < kFilterCells)) return 0.0;
    return table_.pdf(std::size_t(cell)) / (2.0 * radius_);
}

}  // namespace dewbow
