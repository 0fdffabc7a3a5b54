// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/angle_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;
/// How fast steps grow with the distance from where something happens.
constexpr double kGrowth = 0.04;
/// At 0° and 180°, of 1/x.
constexpr double kAtAxis = 0.25;
/// How far the fringes of a bow go on its bright side, and its light on the dark one, in Airy
/// units.
constexpr double kBright = 8.0, kDark = 2.5;
/// Orders whose bows are seen.
constexpr int kBows[] = {2, 3, 4, 5};

/// Angles in radians between which steps are `step`.
struct Zone {
    double from, to, step;

    double step_at(double theta) const {
        return step + kGrowth * std::max({from - theta, theta - to, 0.0});
    }
};

std::vector<Zone> zones_of(const AngleGrid& grid) {
    const double at_axis = kAtAxis / grid.x;
    std::vector<Zone> zones = {{0.0, 0.0, at_axis}, {kPi, kPi, at_axis}};
    for (const int p : kBows) {
        if (!(grid.least.value > 1.0 && grid.greatest.value < p)) continue;
        Zone zone{kPi, 0.0, std::numeric_limits<double>::infinity()};
        for (const RelativeIndex n : {grid.least, grid.greatest}) {
            const DescartesRay bow = descartes_ray(n, p);
            const double at = bow.scattering_angle.to(rad), side = bow.bright_side;
            const double unit = std::cbrt(bow.airy_constant / (grid.x * grid.x));
            const double bright = at + side * kBright * unit, dark = at - side * kDark * unit;
            zone.from = std::min({zone.from, bright, dark});
            zone.to = std::max({zone.to, bright, dark});
            zone.step = std::min(zone.step, unit / grid.parts);
        }
        zones.push_back(zone);
    }
    return zones;
}

}  // namespace

std::vector<Angle> adaptive_angles(const AngleGrid& grid) {
    const std::vector<Zone> zones = zones_of(grid);
    double longest = grid.longest.to(rad);
    if (grid.fringes) longest = std::min(longest, 0.5 * kPi / grid.x);
    const double from = grid.from.to(rad), to = grid.to.to(rad);
    std::vector<Angle> angles;
    for (double theta = from; theta < to;) {
        angles.push_back(theta * rad);
        const auto step_at = [&](double at) {
            double step = longest;
            for (const Zone& zone : zones) step = std::min(step, zone.step_at(at));
            return step;
        };
        // Steps shrink ahead of what they go towards.
        const double step = step_at(theta + step_at(theta));
        theta += std::min(step, step_at(theta));
    }
    // Not a sliver at the end.
    if (angles.size() > 2 &&
        to - angles.back().to(rad) < 0.5 * (angles.back() - angles.end()[-2]).to(rad))
        angles.pop_back();
    angles.push_back(grid.to);
    return angles;
}

std::vector<Angle> merged_angles(std::span<const Angle> a, std::span<const Angle> b) {
    std::vector<Angle> all;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
}

}  // namespace dewbow
