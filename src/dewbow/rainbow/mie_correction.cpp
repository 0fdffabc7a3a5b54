// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie_correction.h"

#include <algorithm>
#include <cmath>

#include "dewbow/rainbow/size_classes.h"

namespace dewbow {
namespace {

using namespace unit;

/// Radii that the sum of orders knows: fringes that a spread of sizes leaves are few.
constexpr std::size_t kSummedRadii = 256;
/// Wavelengths at which Mie theory is asked, and the degree in 1/λ of what goes through its
/// answers.
constexpr std::size_t kNodes = 16, kDegree = 4;
/// What it costs on one core of a present machine: S for x costs x (0.15 ns · angles + 40 ns).
constexpr double kNsPerAngle = 0.15, kNsPerWave = 40.0;
constexpr double kLeastRadii = 8.0;
/// Radii over all nodes for efficiencies alone.
constexpr std::size_t kEfficiencyRadii = 128;

DropAverages averages_of(const Cloud& cloud, Wavelength lambda) {
    std::vector<double> sizes, shares;
    for (const WeightedRadius& drop : grouped(cloud.radii, kSummedRadii)) {
        sizes.push_back(cloud.optics.size_parameter(drop.radius, lambda));
        shares.push_back(drop.share);
    }
    return {sizes, shares};
}

}  // namespace

Efficiencies mixed_efficiencies(std::span<const DropSums> nodes, std::span<const double> weights) {
    Efficiencies sum;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Efficiencies& each = nodes[k].efficiencies;
        sum.extinction += weights[k] * each.extinction;
        sum.scattering += weights[k] * each.scattering;
        sum.asymmetry += weights[k] * each.asymmetry;
    }
    return sum;
}

Intensities mixed_intensities(std::span<const DropSums> nodes, std::span<const double> weights,
                              std::size_t a) {
    Intensities sum;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double weight = weights[k] / nodes[k].x_squared;
        sum.perpendicular += weight * nodes[k].intensities[a].perpendicular;
        sum.parallel += weight * nodes[k].intensities[a].parallel;
    }
    return sum;
}

SummedOrders::SummedOrders(const Cloud& cloud, Wavelength reference,
                           const CompositionFamily& compositions)
    : cloud_(cloud),
      reference_(reference),
      compositions_(compositions),
      averages_(averages_of(cloud, reference)) {}

double SummedOrders::ratio(Wavelength lambda) const {
    return cloud_.optics.size_parameter(1.0 * mm, lambda) /
           cloud_.optics.size_parameter(1.0 * mm, reference_);
}

std::vector<Intensities> SummedOrders::at(Wavelength lambda, std::span<const Angle> angles) const {
    std::vector<Intensities> sum(angles.size());
    if (!angles.empty())
        compositions_.at(cloud_.optics.index(lambda))
            .add(averages_.rescaled(ratio(lambda)), {}, angles, sum);
    return sum;
}

MieCorrection::MieCorrection(const Cloud& cloud, const SummedOrders& orders,
                             std::span<const Wavelength> wavelengths, std::span<const Angle> angles,
                             std::span<const AngleRange> exact, double budget_ns)
    : fit_(wavelengths, kNodes, kDegree) {
    std::vector<Angle> at;
    for (std::size_t a = 0; a < angles.size(); ++a)
        if (const double weight = exact_weight(exact, angles[a]); weight > 0.0) {
            corrected_.push_back(a), weights_.push_back(weight), at.push_back(angles[a]);
        }
    const double x = orders.averages().fringes.effective_size();
    const double ns_per_drop = x * (kNsPerAngle * double(at.size()) + kNsPerWave);
    radius_count_ = std::min(
        radii_needed(cloud, wavelengths.front()),
        std::size_t(std::max(budget_ns / (ns_per_drop * double(node_count())), kLeastRadii)));
    if (at.empty())  // efficiencies alone
        radius_count_ = std::min(radius_count_, kEfficiencyRadii / node_count());
    nodes_.resize(node_count());
    parallel_or_throw(node_count(),
                      [&](std::size_t k) { nodes_[k] = at_node(k, cloud, orders, at); });
}

DropSums MieCorrection::at_node(std::size_t node, const Cloud& cloud, const SummedOrders& orders,
                                std::span<const Angle> angles) const {
    // Other radii at each node: together they are many more.
    constexpr double kGoldenRatio = 0.6180339887498949;
    const double offset = std::fmod(double(node) * kGoldenRatio, 1.0);
    const Wavelength lambda = fit_.nodes()[node];
    DropSums mie = scatter_exactly({cloud.optics, grouped(cloud.radii, radius_count_, offset), {}},
                                   lambda, angles);
    const std::vector<Intensities> sum = orders.at(lambda, angles);
    for (std::size_t a = 0; a < angles.size(); ++a) {
        mie.intensities[a].perpendicular -= sum[a].perpendicular;
        mie.intensities[a].parallel -= sum[a].parallel;
    }
    return mie;
}

Intensities MieCorrection::at(std::size_t w, std::size_t c) const {
    return mixed_intensities(nodes_, fit_.weights(w), c);
}

void MieCorrection::add(std::size_t w, double x_squared, std::span<Intensities> sum) const {
    for (std::size_t c = 0; c < corrected_.size(); ++c) {
        Intensities& total = sum[corrected_[c]];
        const Intensities more = at(w, c);
        const double scale = weights_[c] * x_squared;
        // Where there is next to no light, the correction may be a little larger than the sum.
        total.perpendicular = std::max(total.perpendicular + scale * more.perpendicular, 0.0);
        total.parallel = std::max(total.parallel + scale * more.parallel, 0.0);
    }
}

Efficiencies MieCorrection::efficiencies(std::size_t w) const {
    return mixed_efficiencies(nodes_, fit_.weights(w));
}

}  // namespace dewbow
