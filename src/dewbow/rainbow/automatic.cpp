// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/composition.h"
#include "dewbow/rainbow/wavelength_fit.h"

namespace dewbow {
namespace {

using namespace unit;

/// As part of the cross section, that drops below kLeastSummedSize may have without being asked
/// for.
constexpr double kNegligible = 2e-3;
/// Steps in x at which Mie theory is asked: waves of different orders differ in path by up to five
/// radii, and their interference must not come back at the steps' own rate.
constexpr double kStep = 0.7;
/// Radii that the sum of orders knows. Fringes that a spread of sizes leaves are few.
constexpr std::size_t kSummedRadii = 256;

/// Mie theory for drops of many sizes together is smooth in the wavelength: nodes for all of it.
constexpr std::size_t kExactNodes = 40;
/// And for what it adds to the sum of orders: nodes, and the degree in 1/λ.
constexpr std::size_t kCorrectionNodes = 16, kCorrectionDegree = 4;
/// CPU time that this may take, as it is measured on one core of a present machine: S for x at
/// some angles costs x (0.15 ns · angles + 40 ns).
constexpr double kCorrectionNs = 2.5e8, kNsPerAngle = 0.15, kNsPerWave = 40.0;
constexpr double kLeastRadii = 8.0;
/// Radii over all nodes for efficiencies alone.
constexpr std::size_t kEfficiencyRadii = 128;

/// Classes of drops in about `most` groups, ⟨1⟩ and ⟨r²⟩ kept in each.
/// @param offset  0 to 1: where the groups begin, in groups.
std::vector<WeightedRadius> grouped(std::span<const WeightedRadius> radii, std::size_t most,
                                    double offset) {
    if (radii.size() <= most) return {radii.begin(), radii.end()};
    const double size = double(radii.size()) / double(most);
    std::vector<WeightedRadius> groups;
    std::size_t from = 0;
    for (double g = offset > 0.0 ? offset : 1.0; from < radii.size(); ++g) {
        const std::size_t to = std::min(std::size_t(std::lround(g * size)), radii.size());
        double share = 0.0, square = 0.0;
        for (std::size_t k = from; k < to; ++k) {
            share += radii[k].share;
            square += radii[k].share * std::pow(radii[k].radius.to(m), 2.0);
        }
        if (share > 0.0) groups.push_back({std::sqrt(square / share) * m, share});
        from = to;
    }
    return groups;
}

/// Σ r³ / Σ r², and the standard deviation of r weighted by r².
struct SizeMoments {
    Length effective, deviation;
};
SizeMoments moments_of(std::span<const WeightedRadius> radii) {
    double square = 0.0, cube = 0.0, fourth = 0.0;
    for (const WeightedRadius& drop : radii) {
        const double r = drop.radius.to(m), weight = drop.share * r * r;
        square += weight, cube += weight * r, fourth += weight * r * r;
    }
    const double mean = cube / square;
    return {mean * m, std::sqrt(std::max(fourth / square - mean * mean, 0.0)) * m};
}

/// Radii that Mie theory needs for this cloud, kStep apart.
std::size_t radii_needed(const Cloud& cloud, Wavelength lambda) {
    const Length range = cloud.radii.back().radius - cloud.radii.front().radius;
    return std::size_t(cloud.optics.size_parameter(range, lambda) / kStep) + 16;
}

DropAverages averages_of(const Cloud& cloud, Wavelength lambda) {
    std::vector<double> sizes, shares;
    for (const WeightedRadius& drop : grouped(cloud.radii, kSummedRadii, 0.0)) {
        sizes.push_back(cloud.optics.size_parameter(drop.radius, lambda));
        shares.push_back(drop.share);
    }
    return {sizes, shares};
}

Efficiencies mixed(std::span<const DropSums> nodes, std::span<const double> weights) {
    Efficiencies sum;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Efficiencies& each = nodes[k].efficiencies;
        sum.extinction += weights[k] * each.extinction;
        sum.scattering += weights[k] * each.scattering;
        sum.asymmetry += weights[k] * each.asymmetry;
    }
    return sum;
}

/// Intensities at angle number a, over Σ x².
Intensities mixed(std::span<const DropSums> nodes, std::span<const double> weights, std::size_t a) {
    Intensities sum;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double weight = weights[k] / nodes[k].x_squared;
        sum.perpendicular += weight * nodes[k].intensities[a].perpendicular;
        sum.parallel += weight * nodes[k].intensities[a].parallel;
    }
    return sum;
}

double mean_x_squared(const Cloud& cloud, Wavelength lambda) {
    double sum = 0.0;
    for (const WeightedRadius& drop : cloud.radii)
        sum += drop.share * std::pow(cloud.optics.size_parameter(drop.radius, lambda), 2.0);
    return sum;
}

/// Drops that turn an order's bow by about the same shift.
struct ShiftedDrops {
    FringeAverage fringes;        ///< at the reference wavelength
    Angle at_least, at_greatest;  ///< shift at the least and greatest index
};

/// Of order p, in steps of shift that the sun's disc hides; longer where drops are few and their
/// shifts large, and for the faint bows of orders above 3.
std::vector<ShiftedDrops> shifted_drops(const Cloud& cloud, std::vector<ShapedDrops> shaped, int p,
                                        Wavelength reference) {
    constexpr Angle kFineStep = 0.05 * deg, kCoarseStep = 4.0 * deg;
    constexpr double kOfShift = 0.04, kFringes = 30.0;
    std::sort(shaped.begin(), shaped.end(), [p](const ShapedDrops& a, const ShapedDrops& b) {
        return a.shift(p, 0.5) < b.shift(p, 0.5);
    });
    std::vector<ShiftedDrops> groups;
    for (std::size_t first = 0, last = 0; first < shaped.size(); first = last) {
        std::vector<double> sizes, shares;
        Angle at_least, at_greatest;
        double weight = 0.0;
        const Angle begin = shaped[first].shift(p, 0.5);
        const Angle step = std::max(p <= 3 ? kFineStep : kCoarseStep, kOfShift * abs(begin));
        for (; last < shaped.size() && shaped[last].shift(p, 0.5) - begin <= step; ++last) {
            const WeightedRadius& drop = cloud.radii[shaped[last].radius];
            sizes.push_back(cloud.optics.size_parameter(drop.radius, reference));
            shares.push_back(drop.share * shaped[last].share);
            const double section = shares.back() * sizes.back() * sizes.back();
            weight += section;
            at_least += section * shaped[last].shift(p, 0.0);
            at_greatest += section * shaped[last].shift(p, 1.0);
        }
        groups.push_back(
            {FringeAverage(sizes, shares, kFringes), at_least / weight, at_greatest / weight});
    }
    return groups;
}

/// Large drops of many sizes: the sum of orders, corrected by Mie theory where the plan says so.
class LargeDrops {
public:
    LargeDrops(const Cloud& cloud, std::span<const Wavelength> wavelengths,
               std::span<const Angle> angles, const Orders& orders, const AutomaticPlan& plan);
    DropSums sums(std::size_t wavelength) const;
    std::size_t node_count() const { return fit_.nodes().size(); }
    std::size_t radius_count() const { return radius_count_; }

private:
    /// What Mie theory adds to the sum at some angles, and efficiencies, at a node.
    DropSums correction_at(std::size_t node, std::span<const Angle> angles) const;
    /// The sum of orders of spheres, or of what falls.
    std::vector<Intensities> composed(Wavelength lambda, std::span<const Angle> angles) const;
    std::vector<Intensities> composed_falling(Wavelength lambda,
                                              std::span<const Angle> angles) const;
    double size_ratio(Wavelength lambda) const {
        return cloud_.optics.size_parameter(1.0 * mm, lambda) /
               cloud_.optics.size_parameter(1.0 * mm, reference_);
    }

    const Cloud& cloud_;
    std::span<const Wavelength> wavelengths_;
    std::span<const Angle> angles_;
    Wavelength reference_;
    CompositionFamily compositions_;
    DropAverages averages_;                           ///< at the reference wavelength
    std::vector<std::vector<ShiftedDrops>> shifted_;  ///< by order, if drops fall
    WavelengthFit fit_;
    std::size_t radius_count_ = 0;        ///< at each node
    std::vector<std::size_t> corrected_;  ///< numbers of angles
    std::vector<double> weights_;         ///< how much of the correction counts there
    std::vector<DropSums> corrections_;   ///< [node]
};

LargeDrops::LargeDrops(const Cloud& cloud, std::span<const Wavelength> wavelengths,
                       std::span<const Angle> angles, const Orders& orders,
                       const AutomaticPlan& plan)
    : cloud_(cloud),
      wavelengths_(wavelengths),
      angles_(angles),
      reference_(wavelengths[wavelengths.size() / 2]),
      compositions_(cloud.optics.index(wavelengths.back()), cloud.optics.index(wavelengths.front()),
                    orders),
      averages_(averages_of(cloud, reference_)),
      fit_(wavelengths, kCorrectionNodes, kCorrectionDegree) {
    if (cloud.falling) {
        const Cloud some{cloud.optics, grouped(cloud.radii, kSummedRadii, 0.0), {}};
        const std::vector<ShapedDrops> shaped =
            shape_drops(some.radii, cloud.falling, cloud.optics.index(wavelengths.back()),
                        cloud.optics.index(wavelengths.front()));
        shifted_.resize(kHighestOrder + 1);
        for (int p = 2; p <= kHighestOrder; ++p)
            shifted_[std::size_t(p)] = shifted_drops(some, shaped, p, reference_);
    }
    std::vector<Angle> exact;
    if (orders.empty())
        for (std::size_t a = 0; a < angles.size(); ++a)
            if (const double weight = exact_weight(plan.exact, angles[a]); weight > 0.0) {
                corrected_.push_back(a), weights_.push_back(weight), exact.push_back(angles[a]);
            }
    const double ns_per_drop =
        averages_.fringes.effective_size() * (kNsPerAngle * double(exact.size()) + kNsPerWave);
    radius_count_ = std::min(
        radii_needed(cloud, reference_),
        std::size_t(std::max(kCorrectionNs / (ns_per_drop * double(node_count())), kLeastRadii)));
    if (exact.empty())  // efficiencies alone
        radius_count_ = std::min(radius_count_, kEfficiencyRadii / node_count());
    corrections_.resize(node_count());
    parallel_or_throw(node_count(),
                      [&](std::size_t k) { corrections_[k] = correction_at(k, exact); });
}

DropSums LargeDrops::correction_at(std::size_t node, std::span<const Angle> angles) const {
    // Other radii at each node: together they are many more.
    constexpr double kGoldenRatio = 0.6180339887498949;
    const double offset = std::fmod(double(node) * kGoldenRatio, 1.0);
    const Wavelength lambda = fit_.nodes()[node];
    const Cloud some{cloud_.optics, grouped(cloud_.radii, radius_count_, offset), {}};
    DropSums mie = scatter_exactly(some, lambda, angles);
    const std::vector<Intensities> sum = composed(lambda, angles);
    for (std::size_t a = 0; a < angles.size(); ++a) {
        mie.intensities[a].perpendicular -= sum[a].perpendicular;
        mie.intensities[a].parallel -= sum[a].parallel;
    }
    return mie;
}

std::vector<Intensities> LargeDrops::composed(Wavelength lambda,
                                              std::span<const Angle> angles) const {
    std::vector<Intensities> sum(angles.size());
    if (!angles.empty())
        compositions_.at(cloud_.optics.index(lambda))
            .add(averages_.rescaled(size_ratio(lambda)), {}, angles, sum);
    return sum;
}

std::vector<Intensities> LargeDrops::composed_falling(Wavelength lambda,
                                                      std::span<const Angle> angles) const {
    std::vector<Intensities> sum(angles.size());
    const double ratio = size_ratio(lambda);
    const RelativeIndex n = cloud_.optics.index(lambda),
                        least = cloud_.optics.index(wavelengths_.back()),
                        greatest = cloud_.optics.index(wavelengths_.front());
    const double range = greatest.value - least.value,
                 t = range != 0.0 ? (n.value - least.value) / range : 0.0;
    const Composition composition = compositions_.at(n);
    composition.add_beside_bows(averages_.rescaled(ratio), angles, sum);
    for (const OrderPattern& bow : composition.bows())
        for (const ShiftedDrops& drops : shifted_[std::size_t(bow.order())])
            bow.at(angles, drops.at_least + t * (drops.at_greatest - drops.at_least))
                .add(drops.fringes.rescaled(ratio), sum);
    return sum;
}

DropSums LargeDrops::sums(std::size_t wavelength) const {
    const Wavelength lambda = wavelengths_[wavelength];
    const auto weights = fit_.weights(wavelength);
    DropSums sums;
    sums.intensities =
        cloud_.falling ? composed_falling(lambda, angles_) : composed(lambda, angles_);
    sums.x_squared = mean_x_squared(cloud_, lambda);
    sums.efficiencies = mixed(corrections_, weights);
    for (std::size_t c = 0; c < corrected_.size(); ++c) {
        Intensities& sum = sums.intensities[corrected_[c]];
        const Intensities more = mixed(corrections_, weights, c);
        const double scale = weights_[c] * sums.x_squared;
        // Where there is next to no light, the correction may be a little larger than the sum.
        sum.perpendicular = std::max(sum.perpendicular + scale * more.perpendicular, 0.0);
        sum.parallel = std::max(sum.parallel + scale * more.parallel, 0.0);
    }
    return sums;
}

/// Mie theory for all drops.
/// @param smooth  whether sizes differ so much that the result is smooth in the wavelength.
std::vector<DropSums> exactly(const Cloud& all, std::span<const Wavelength> wavelengths,
                              std::span<const Angle> angles, bool smooth) {
    const Cloud cloud{
        all.optics, grouped(all.radii, radii_needed(all, wavelengths.front()), 0.0), {}};
    std::vector<DropSums> sums(wavelengths.size());
    if (!smooth || wavelengths.size() <= kExactNodes) {
        parallel_or_throw(wavelengths.size(), [&](std::size_t w) {
            sums[w] = scatter_exactly(cloud, wavelengths[w], angles);
        });
        return sums;
    }
    const WavelengthFit fit(wavelengths, kExactNodes, kExactNodes - 1);
    std::vector<DropSums> nodes(kExactNodes);
    parallel_or_throw(kExactNodes, [&](std::size_t k) {
        nodes[k] = scatter_exactly(cloud, fit.nodes()[k], angles);
    });
    parallel_or_throw(wavelengths.size(), [&](std::size_t w) {
        DropSums& sum = sums[w];
        sum.efficiencies = mixed(nodes, fit.weights(w));
        sum.x_squared = mean_x_squared(cloud, wavelengths[w]);
        sum.intensities.resize(angles.size());
        for (std::size_t a = 0; a < angles.size(); ++a) {
            const Intensities at = mixed(nodes, fit.weights(w), a);
            sum.intensities[a] = {sum.x_squared * at.perpendicular, sum.x_squared * at.parallel};
        }
    });
    return sums;
}

/// Which drops are left to Mie theory alone.
struct Division {
    Cloud exact, summed;
    bool exact_smooth = false;  ///< see exactly()
};
Division divide(const Cloud& cloud, Wavelength lambda, bool orders) {
    const Cloud none{cloud.optics, {}, cloud.falling};
    Division division{none, none};
    double small = 0.0, all = 0.0;
    for (const WeightedRadius& drop : cloud.radii) {
        const double x = cloud.optics.size_parameter(drop.radius, lambda);
        const double section = drop.share * x * x;
        all += section;
        if (x < kLeastSummedSize) small += section;
        (x < kLeastSummedSize ? division.exact : division.summed).radii.push_back(drop);
    }
    if (orders) {
        if (small > 0.5 * all)
            throw InputError(
                fmt::format("model \"auto\" has orders of light for drops with x >= {:.0f} only",
                            kLeastSummedSize),
                "model \"debye\" has them for all");
        return {none, cloud};
    }
    const SizeMoments moments = moments_of(cloud.radii);
    division.exact_smooth =
        cloud.optics.size_parameter(moments.deviation, lambda) >= kWashedOutDeviation;
    const bool clear =
        is_clear(cloud.optics.extinction, cloud.optics.size_parameter(moments.effective, lambda));
    if (division.summed.radii.empty() || !division.exact_smooth || !clear)
        return {cloud, none, division.exact_smooth};
    if (small < kNegligible * all) return {none, cloud};
    return division;
}

std::string describe(const AutomaticPlan& plan, const LargeDrops& drops) {
    std::string text = "the sum of orders 0 to 7 and diffraction";
    if (plan.exact.empty()) return text;
    text += ", corrected";
    for (std::size_t r = 0; r < plan.exact.size(); ++r)
        text += fmt::format("{} {:.0f}° to {:.0f}°", r == 0 ? " at" : ",",
                            plan.exact[r].from.to(deg), plan.exact[r].to.to(deg));
    return text + fmt::format(" by mie at {} radii and {} wavelengths", drops.radius_count(),
                              drops.node_count());
}

}  // namespace

CloudScattering scatter_automatically(const Cloud& cloud, std::span<const Wavelength> wavelengths,
                                      std::span<const Angle> angles, const ModelOptions& options) {
    const Wavelength middle = wavelengths[wavelengths.size() / 2];
    const Division division = divide(cloud, middle, !options.orders.empty());
    CloudScattering result;
    const auto sizes = [&](const Cloud& part) {
        return fmt::format("x = {:.0f} to {:.0f}",
                           part.optics.size_parameter(part.radii.front().radius, middle),
                           part.optics.size_parameter(part.radii.back().radius, middle));
    };
    if (!division.exact.radii.empty()) {
        result.sums = exactly(division.exact, wavelengths, angles, division.exact_smooth);
        result.report = fmt::format("{}: mie", sizes(division.exact));
    }
    if (division.summed.radii.empty()) return result;

    const Length effective = moments_of(division.summed.radii).effective;
    const AutomaticPlan plan =
        plan_angles(cloud.optics.size_parameter(effective, middle),
                    is_point(options.averaging.disc_radius), options.tolerance);
    const LargeDrops large(division.summed, wavelengths, angles, options.orders, plan);
    result.sums.resize(wavelengths.size());
    parallel_or_throw(wavelengths.size(), [&](std::size_t w) {
        DropSums sums = large.sums(w);
        if (division.exact.radii.empty())
            result.sums[w] = std::move(sums);
        else
            result.sums[w].add(sums);
    });
    result.report += fmt::format("{}{}: {}", result.report.empty() ? "" : "; ",
                                 sizes(division.summed), describe(plan, large));
    result.stated_error = plan.error;
    return result;
}

}  // namespace dewbow
