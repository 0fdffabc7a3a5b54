// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/least_squares.h"

#include <numeric>

#include "dewbow/base/check.h"

namespace dewbow {
namespace {

constexpr double kDependent = 1e-14;

double dot(std::span<const double> u, std::span<const double> v) {
    return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

/// Takes `v` to v − 2 h (h·v)/(h·h).
void reflect(std::span<const double> h, double h_squared, std::span<double> v) {
    const double share = 2.0 * dot(h, v) / h_squared;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] -= share * h[i];
}

}  // namespace

std::vector<double> least_squares(std::span<const double> a, std::span<const double> b) {
    const std::size_t rows = b.size(), columns = rows ? a.size() / rows : 0;
    DEWBOW_CHECK(columns * rows == a.size() && rows >= columns, "as many rows as columns, or more");
    std::vector<double> r(a.begin(), a.end()), y(b.begin(), b.end());
    std::vector<bool> depends(columns, false);
    const auto below = [&](std::size_t column, std::size_t from) {
        return std::span(r).subspan(column * rows + from, rows - from);
    };
    for (std::size_t k = 0; k < columns; ++k) {
        const std::span<double> column = below(k, k);
        const double length = std::sqrt(dot(column, column)),
                     whole = std::sqrt(dot(below(k, 0), below(k, 0)));
        depends[k] = !(length > kDependent * whole);
        if (depends[k]) continue;
        std::vector<double> h(column.begin(), column.end());
        h[0] += std::copysign(length, h[0]);
        const double h_squared = dot(h, h);
        for (std::size_t j = k; j < columns; ++j) reflect(h, h_squared, below(j, k));
        reflect(h, h_squared, std::span(y).subspan(k));
    }
    std::vector<double> x(columns, 0.0);
    for (std::size_t k = columns; k-- > 0;) {
        if (depends[k]) continue;
        double rest = y[k];
        for (std::size_t j = k + 1; j < columns; ++j) rest -= r[j * rows + k] * x[j];
        x[k] = rest / r[k * rows + k];
    }
    return x;
}

}  // namespace dewbow
