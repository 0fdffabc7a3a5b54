// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/ray_pair_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/base/simd.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTerms = RayPairSeries::kTerms;
constexpr int kPairFunctions = RayPair<double>::kCount;
constexpr int kFunctions = RayPairSeries::kFunctions;
using Block = RayPairSeries::Block;
using Series = RayPairSeries::Series;

/// Nodes in the index.
constexpr int kIndexTerms = 10;
/// The largest σ that is covered; for p = 2 the complex rays meet a singular point near 2.6.
double largest_sigma(int p) { return p == 2 ? 2.2 : 3.0; }

/// The k-th of `count` Chebyshev nodes of the first kind, in [-1, 1].
double chebyshev_node(int k, int count) { return std::cos(kPi * (k + 0.5) / count); }
/// What makes a sum over nodes j the coefficient of T_k.
double analysis_weight(int k, int j, int count) {
    return std::cos(kPi * k * (j + 0.5) / count) * (k == 0 ? 1.0 : 2.0) / count;
}

void add(Series& sum, const Series& term, double weight) {
    for (int f = 0; f < kFunctions; ++f)
        for (int j = 0; j < kTerms; ++j) sum[f][j] += weight * term[f][j];
}

/// The range of √(D - least) with one ray.
struct LoneRange {
    double middle, half;
    explicit LoneRange(const BowGeometry& bow) {
        const double from = std::sqrt(bow.span), to = std::sqrt(bow.most - bow.least);
        middle = 0.5 * (from + to), half = 0.5 * (to - from);
    }
};

/// All functions at the j-th node.
std::array<double, kFunctions> node_values(const BowGeometry& bow, int j) {
    const double t = chebyshev_node(j, kTerms);
    std::array<double, kFunctions> values;
    const double sigma = 0.5 * largest_sigma(bow.p) * (1.0 + t);
    RayPair<double> pair = ray_pair(bow, bow.span * (1.0 - sigma * sigma));
    for (double* next : pair.singular()) *next *= sigma * sigma * sigma;
    for (int f = 0; f < kPairFunctions; ++f) values[f] = *pair.list()[f];
    // dD/db vanishes at the bow as √(D - least).
    const LoneRange range(bow);
    const double s = range.middle + range.half * t;
    const LoneRay ray = lone_ray(bow, s * s);
    values[kPairFunctions] = ray.path;
    values[kPairFunctions + 1] = ray.perpendicular * std::sqrt(s);
    values[kPairFunctions + 2] = ray.parallel * std::sqrt(s);
    return values;
}

Series series_of(const BowGeometry& bow) {
    Series series{};
    for (int j = 0; j < kTerms; ++j) {
        const auto values = node_values(bow, j);
        for (int f = 0; f < kFunctions; ++f)
            for (int k = 0; k < kTerms; ++k)
                series[f][k] += values[f] * analysis_weight(k, j, kTerms);
    }
    return series;
}

/// The coefficients of one order, as Chebyshev series in the index.
class OrderSeries {
public:
    explicit OrderSeries(int p) : terms_(kIndexTerms) {
        for (int i = 0; i < kIndexTerms; ++i) {
            const double t = chebyshev_node(i, kIndexTerms);
            const Series one = series_of(bow_geometry({kMiddle + kHalf * t}, p));
            for (int k = 0; k < kIndexTerms; ++k)
                add(terms_[k], one, analysis_weight(k, i, kIndexTerms));
        }
    }
    Series at(double n) const {
        const double angle = std::acos(std::clamp((n - kMiddle) / kHalf, -1.0, 1.0));
        Series sum{};
        for (int k = 0; k < kIndexTerms; ++k) add(sum, terms_[k], std::cos(k * angle));
        return sum;
    }

private:
    static constexpr double kMiddle = 0.5 * (kLowestBowIndex + kHighestBowIndex);
    static constexpr double kHalf = 0.5 * (kHighestBowIndex - kLowestBowIndex);
    std::vector<Series> terms_;
};

/// Made when its order is first asked for.
const OrderSeries& order_series(int p) {
    constexpr int kOrders = kHighestBow - kLowestBow + 1;
    static std::array<std::once_flag, kOrders> made;
    static std::array<std::unique_ptr<const OrderSeries>, kOrders> all;
    const auto k = static_cast<std::size_t>(p - kLowestBow);
    std::call_once(made[k], [&] { all[k] = std::make_unique<const OrderSeries>(p); });
    return *all[k];
}

/// Σ_k coefficients[k] T_k(t) for `count` values of t.                               [Clenshaw
/// 1955]
DEWBOW_SIMD void sum_series(const std::array<double, kTerms>& coefficients, const Block& t,
                            std::size_t count, Block& sum) {
    Block last{}, before{};
    for (int k = kTerms - 1; k >= 1; --k)
        for (std::size_t i = 0; i < count; ++i) {
            const double next = coefficients[k] + 2.0 * t[i] * last[i] - before[i];
            before[i] = last[i], last[i] = next;
        }
    for (std::size_t i = 0; i < count; ++i) sum[i] = coefficients[0] + t[i] * last[i] - before[i];
}

}  // namespace

RayPairSeries::RayPairSeries(RelativeIndex n, int p) {
    if (!(n.value >= kLowestBowIndex && n.value <= kHighestBowIndex))
        throw InputError(fmt::format("index {}; Airy models of bows take {:.2f} to {:.2f}", n.value,
                                     kLowestBowIndex, kHighestBowIndex));
    if (p < kLowestBow || p > kHighestBow)
        throw InputError(
            fmt::format("order {}; Airy models of bows have {} to {}", p, kLowestBow, kHighestBow));
    geometry_ = bow_geometry(n, p);
    series_ = order_series(p).at(n.value);
}

double RayPairSeries::darkest() const {
    const double sigma = largest_sigma(geometry_.p);
    return geometry_.grazing() - geometry_.span * sigma * sigma;
}

double RayPairSeries::sigma(double deviation) const {
    return std::sqrt((geometry_.grazing() - deviation) / geometry_.span);
}

RayPair<Block> RayPairSeries::pairs(const Block& deviations, std::size_t count) const {
    Block t{}, growth{};
    for (std::size_t i = 0; i < count; ++i) {
        const double s = sigma(deviations[i]);
        t[i] = 2.0 * s / largest_sigma(geometry_.p) - 1.0;
        growth[i] = 1.0 / (s * s * s);
    }
    RayPair<Block> pair;
    const auto values = pair.list();
    for (int f = 0; f < kPairFunctions; ++f) sum_series(series_[f], t, count, *values[f]);
    for (Block* next : pair.singular())
        for (std::size_t i = 0; i < count; ++i) (*next)[i] *= growth[i];
    return pair;
}

RayPair<Block> RayPairSeries::lone(const Block& deviations, std::size_t count) const {
    const LoneRange range(geometry_);
    Block t{}, path, perpendicular, parallel;
    for (std::size_t i = 0; i < count; ++i)
        t[i] = (std::sqrt(deviations[i] - geometry_.least) - range.middle) / range.half;
    sum_series(series_[kPairFunctions], t, count, path);
    sum_series(series_[kPairFunctions + 1], t, count, perpendicular);
    sum_series(series_[kPairFunctions + 2], t, count, parallel);
    RayPair<Block> block;
    const auto to = block.list();
    for (std::size_t i = 0; i < count; ++i) {
        const double offset = deviations[i] - geometry_.least, root4 = std::pow(offset, -0.25);
        const RayPair<double> one =
            lone_pair(geometry_, offset, {path[i], perpendicular[i] * root4, parallel[i] * root4});
        const auto from = one.list();
        for (int f = 0; f < kPairFunctions; ++f) (*to[f])[i] = *from[f];
    }
    return block;
}

RayPair<double> RayPairSeries::at(double deviation) const {
    const Block one{deviation};
    const RayPair<Block> block = deviation < geometry_.grazing() ? pairs(one, 1) : lone(one, 1);
    RayPair<double> pair;
    const auto from = block.list();
    const auto to = pair.list();
    for (int f = 0; f < kPairFunctions; ++f) *to[f] = (*from[f])[0];
    return pair;
}

}  // namespace dewbow
