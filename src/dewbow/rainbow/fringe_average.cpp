// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/fringe_average.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/airy.h"

namespace dewbow {
namespace {

/// Steps in z x^{2/3} of the largest drop: fringes far from the bow, with z x^{2/3} = 100, are 0.3
/// long there.
constexpr double kStep = 0.04;
/// No pair of rays of orders 2 to 7 in anything like water reaches this z.
constexpr double kGreatest = 1.2;
/// Ends the dark side: Ai² there is 1e-8 of the bow's.
constexpr double kDarkest = 5.0;
/// Fringes count as washed out when their contrast stays below this for kCalm nodes.
constexpr double kWashedOut = 5e-4;
constexpr int kCalm = 200;

struct Power {
    double x, third, share;  ///< third: x^{1/3}
};

}  // namespace

FringeAverage::FringeAverage(std::span<const double> sizes, std::span<const double> shares,
                             double most_fringes) {
    std::vector<Power> drops(sizes.size());
    double least = sizes[0], greatest = sizes[0], cube = 0.0;
    for (std::size_t d = 0; d < sizes.size(); ++d) {
        const double x = sizes[d];
        drops[d] = {x, std::cbrt(x), shares[d]};
        least = std::min(least, x), greatest = std::max(greatest, x);
        mean_square_ += shares[d] * x * x;
        cube += shares[d] * x * x * x;
    }
    effective_size_ = cube / mean_square_;

    step_ = kStep * std::pow(greatest, -2.0 / 3.0);
    per_step_ = 1.0 / step_;
    // Small drops matter little to a sum of x^{7/3}: no need to follow the least to its dark end.
    const double small = std::max(least, 0.1 * effective_size_);
    first_ = -step_ * std::ceil(kDarkest * std::pow(small, -2.0 / 3.0) / step_);
    const AiryTable& table = AiryTable::instance();
    std::vector<double> arguments(drops.size()), ai(drops.size()), derivative(drops.size());
    const auto node_at = [&](double z) {
        // Where the table ends Ai is 1e-19 of its peak.
        for (std::size_t d = 0; d < drops.size(); ++d)
            arguments[d] = std::min(-z * drops[d].third * drops[d].third, AiryTable::kHighest);
        table.eval(arguments, ai, derivative);
        Node node{};
        for (std::size_t d = 0; d < drops.size(); ++d) {
            const Power& drop = drops[d];
            const double weight = drop.share * drop.x * drop.x;
            node.G += weight * drop.third * ai[d] * ai[d];
            node.H += weight / drop.third * derivative[d] * derivative[d];
            node.slope += weight * drop.x * ai[d] * derivative[d];
        }
        return node;
    };
    // m = (2/3π) ζ^{3/2} fringes lie between the bow and ζ = z x^{2/3}.
    const double last =
        std::min(kGreatest, std::pow(1.5 * std::numbers::pi * most_fringes / greatest, 2.0 / 3.0));
    auto nodes = std::make_shared<std::vector<Node>>();
    int calm = 0;
    for (double k = 0.0; calm < kCalm; ++k) {
        const double z = first_ + k * step_;
        if (z > last) break;
        nodes->push_back(node_at(z));
        const double mean = z > 0.0 ? mean_square_ / (2.0 * std::numbers::pi * std::sqrt(z)) : 0.0;
        calm = std::abs(nodes->back().G - mean) <= kWashedOut * mean ? calm + 1 : 0;
    }
    nodes_ = std::move(nodes);
}

FringeAverage FringeAverage::rescaled(double ratio) const {
    FringeAverage result = *this;
    result.scale_ *= ratio;
    result.scale_z_ = std::pow(result.scale_, 2.0 / 3.0);
    result.scale_H_ = result.scale_ * result.scale_z_;
    result.scale_G_ = result.scale_H_ * result.scale_z_;
    return result;
}

}  // namespace dewbow
