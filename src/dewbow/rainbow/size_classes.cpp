// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/size_classes.h"

#include <algorithm>
#include <cmath>

namespace dewbow {

using namespace unit;

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

SizeMoments moments_of(std::span<const WeightedRadius> radii) {
    double square = 0.0, cube = 0.0, fourth = 0.0;
    for (const WeightedRadius& drop : radii) {
        const double r = drop.radius.to(m), weight = drop.share * r * r;
        square += weight, cube += weight * r, fourth += weight * r * r;
    }
    const double mean = cube / square;
    return {mean * m, std::sqrt(std::max(fourth / square - mean * mean, 0.0)) * m};
}

std::size_t radii_needed(const Cloud& cloud, Wavelength lambda) {
    constexpr double kStep = 0.7;
    const Length range = cloud.radii.back().radius - cloud.radii.front().radius;
    return std::size_t(cloud.optics.size_parameter(range, lambda) / kStep) + 16;
}

double mean_x_squared(const Cloud& cloud, Wavelength lambda) {
    double sum = 0.0;
    for (const WeightedRadius& drop : cloud.radii)
        sum += drop.share * std::pow(cloud.optics.size_parameter(drop.radius, lambda), 2.0);
    return sum;
}

}  // namespace dewbow
