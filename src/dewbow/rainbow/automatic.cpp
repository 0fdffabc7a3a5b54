// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/large_drops.h"
#include "dewbow/rainbow/size_classes.h"
#include "dewbow/rainbow/wavelength_fit.h"

namespace dewbow {
namespace {

using namespace unit;

/// As part of the cross section, that drops below kLeastSummedSize may have without being asked
/// for.
constexpr double kNegligible = 2e-3;
/// Mie theory for drops of many sizes together is smooth in the wavelength: nodes for all of it.
constexpr std::size_t kExactNodes = 40;

/// Mie theory for all drops.
/// @param smooth  whether sizes differ so much that the result is smooth in the wavelength.
std::vector<DropSums> exactly(const Cloud& all, std::span<const Wavelength> wavelengths,
                              std::span<const Angle> angles, bool smooth) {
    const Cloud cloud{all.optics, grouped(all.radii, radii_needed(all, wavelengths.front())), {}};
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
        sum.efficiencies = mixed_efficiencies(nodes, fit.weights(w));
        sum.x_squared = mean_x_squared(cloud, wavelengths[w]);
        sum.intensities.resize(angles.size());
        for (std::size_t a = 0; a < angles.size(); ++a) {
            const Intensities at = mixed_intensities(nodes, fit.weights(w), a);
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

std::string describe(const AutomaticPlan& plan, const MieCorrection& by) {
    std::string text = "the sum of orders 0 to 7 and diffraction";
    if (plan.exact.empty()) return text;
    text += ", corrected";
    for (std::size_t r = 0; r < plan.exact.size(); ++r)
        text += fmt::format("{} {:.0f}° to {:.0f}°", r == 0 ? " at" : ",",
                            plan.exact[r].from.to(deg), plan.exact[r].to.to(deg));
    return text + fmt::format(" by mie at {} radii and {} wavelengths", by.radius_count(),
                              by.node_count());
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
    const LargeDrops large(division.summed, wavelengths, angles, options.orders, plan.exact);
    result.sums.resize(wavelengths.size());
    parallel_or_throw(wavelengths.size(), [&](std::size_t w) {
        DropSums sums = large.sums(w);
        if (division.exact.radii.empty())
            result.sums[w] = std::move(sums);
        else
            result.sums[w].add(sums);
    });
    result.report += fmt::format("{}{}: {}", result.report.empty() ? "" : "; ",
                                 sizes(division.summed), describe(plan, large.correction()));
    result.stated_error = plan.error;
    return result;
}

}  // namespace dewbow
