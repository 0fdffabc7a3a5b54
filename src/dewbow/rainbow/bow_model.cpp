// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/bow_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/ray_pair.h"

namespace dewbow {
namespace {

Intensities squared(const Amplitudes& s) {
    return {std::norm(s.perpendicular), std::norm(s.parallel)};
}

}  // namespace

void check_bow_size(double x) {
    if (!(x >= kSmallestBowSize && x <= kLargestBowSize))
        throw InputError(fmt::format("size parameter {}; Airy models of bows take {} to {}", x,
                                     kSmallestBowSize, kLargestBowSize));
}

BowModel::BowModel(const Orders& asked, const Orders& all) : orders_(asked.empty() ? all : asked) {
    for (int p : orders_)
        if (p < kLowestBow || p > kHighestBow)
            throw InputError(fmt::format("order {}; Airy models of bows have {} to {}", p,
                                         kLowestBow, kHighestBow));
    std::sort(orders_.begin(), orders_.end());
    orders_.erase(std::unique(orders_.begin(), orders_.end()), orders_.end());
}

std::vector<std::unique_ptr<BowPattern>> BowModel::patterns(ComplexIndex index,
                                                            std::span<const Drop> drops) const {
    if (!index.is_real())
        throw InputError(
            fmt::format("{} cannot treat a drop that absorbs (k = {}); expected k = "
                        "0, or the model mie",
                        name(), index.k));
    for (const Drop& drop : drops) check_bow_size(drop.size_parameter);
    std::vector<std::unique_ptr<BowPattern>> made;
    for (int p : orders_) made.push_back(make_pattern({index.n}, p));
    return made;
}

void BowModel::amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                          std::span<Amplitudes> out) const {
    std::fill(out.begin(), out.end(), Amplitudes{});
    for (const auto& pattern : patterns(index, {&drop, 1}))
        pattern->add_amplitudes({&drop, 1}, theta, out);
}

void BowModel::intensities(ComplexIndex index, std::span<const Drop> drops,
                           std::span<const Angle> theta, std::span<Intensities> out) const {
    std::vector<Amplitudes> sums(out.size());
    for (const auto& pattern : patterns(index, drops)) pattern->add_amplitudes(drops, theta, sums);
    std::transform(sums.begin(), sums.end(), out.begin(), squared);
}

Efficiencies BowModel::efficiencies(ComplexIndex index, const Drop& drop) const {
    patterns(index, {&drop, 1});  // refuses what it cannot treat
    double scattering = 0.0, forward = 0.0;
    for (int p : orders_) {
        const OrderFlux order = order_flux({index.n}, p);
        scattering += order.flux.unpolarised();
        forward += order.flux_times_cosine.unpolarised();
    }
    return {scattering, scattering, forward / scattering};
}

}  // namespace dewbow
