// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/large_drops.h"

#include <algorithm>

#include "dewbow/rainbow/cloud_shapes.h"
#include "dewbow/rainbow/size_classes.h"

namespace dewbow {
namespace {

using namespace unit;

/// CPU time for corrections by Mie theory, as much as the rest of a large table takes.
constexpr double kCorrectionNs = 2.5e8;
/// Radii with shapes of their own.
constexpr std::size_t kShapedRadii = 256;

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

}  // namespace

LargeDrops::LargeDrops(const Cloud& cloud, std::span<const Wavelength> wavelengths,
                       std::span<const Angle> angles, const Orders& orders,
                       std::span<const AngleRange> exact)
    : cloud_(cloud),
      wavelengths_(wavelengths),
      angles_(angles),
      least_(cloud.optics.index(wavelengths.back())),
      greatest_(cloud.optics.index(wavelengths.front())),
      compositions_(least_, greatest_, orders),
      orders_(cloud, wavelengths[wavelengths.size() / 2], compositions_),
      correction_(cloud, orders_, wavelengths, angles,
                  orders.empty() ? exact : std::span<const AngleRange>{}, kCorrectionNs) {
    if (!cloud.falling) return;
    const Cloud some{cloud.optics, grouped(cloud.radii, kShapedRadii), {}};
    const std::vector<ShapedDrops> shaped =
        shape_drops(some.radii, cloud.falling, least_, greatest_);
    shifted_.resize(kHighestOrder + 1);
    for (int p = 2; p <= kHighestOrder; ++p)
        shifted_[std::size_t(p)] =
            shifted_drops(some, shaped, p, wavelengths[wavelengths.size() / 2]);
}

void LargeDrops::add_shifted(Wavelength lambda, std::span<Intensities> sum) const {
    const RelativeIndex n = cloud_.optics.index(lambda);
    const double range = greatest_.value - least_.value,
                 t = range != 0.0 ? (n.value - least_.value) / range : 0.0;
    const double ratio = orders_.ratio(lambda);
    const Composition composition = compositions_.at(n);
    composition.add_beside_bows(orders_.averages().rescaled(ratio), angles_, sum);
    for (const OrderPattern& bow : composition.bows())
        for (const ShiftedDrops& drops : shifted_[std::size_t(bow.order())])
            bow.at(angles_, drops.at_least + t * (drops.at_greatest - drops.at_least))
                .add(drops.fringes.rescaled(ratio), sum);
}

DropSums LargeDrops::sums(std::size_t wavelength) const {
    const Wavelength lambda = wavelengths_[wavelength];
    DropSums sums;
    if (shifted_.empty()) {
        sums.intensities = orders_.at(lambda, angles_);
    } else {
        sums.intensities.resize(angles_.size());
        add_shifted(lambda, sums.intensities);
    }
    sums.x_squared = mean_x_squared(cloud_, lambda);
    sums.efficiencies = correction_.efficiencies(wavelength);
    correction_.add(wavelength, sums.x_squared, sums.intensities);
    return sums;
}

}  // namespace dewbow
