// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/haze_lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/render/brightness.h"
#include "dewbow/render/haze/lit_part.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
/// Lamps are looked at one by one up to this number; more are taken together by where they stand.
constexpr std::size_t kMostNear = 16;
static_assert(kMostNear + 2 < DistanceDensity::kMostTerms);
/// Share of the points that goes evenly to the whole ray, lit or not. A tenth costs a tenth more
/// noise where all is known, and bounds it where a lamp is behind something.
constexpr double kEvenShare = 0.1;
/// Cones are wider than what they hold: light at their very edge is found too.
constexpr double kWider = 1.001, kWider_rad = 1e-6;

/// Halves the lamps, by where they stand, until there are at most `most` of them.
void join_neighbours(std::vector<LightBounds> lamps, std::size_t most,
                     std::vector<LightBounds>& out) {
    if (lamps.empty()) return;
    if (most <= 1 || lamps.size() == 1) {
        LightBounds all = lamps.front();
        for (std::size_t i = 1; i < lamps.size(); ++i) all = join(all, lamps[i]);
        out.push_back(all);
        return;
    }
    Bounds centres;
    for (const LightBounds& lamp : lamps) centres.add(lamp.box.centre());
    const Vec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = lamps.begin() + std::ptrdiff_t(lamps.size() / 2);
    std::nth_element(lamps.begin(), middle, lamps.end(), [&](const auto& a, const auto& b) {
        return a.box.centre()[axis] < b.box.centre()[axis];
    });
    join_neighbours({lamps.begin(), middle}, most / 2, out);
    join_neighbours({middle, lamps.end()}, most - most / 2, out);
}

}  // namespace

HazeLamps::HazeLamps(const Scene& scene, const LightSet& lights)
    : far_irradiance_(lights.far_irradiance()) {
    std::vector<LightBounds> lamps = lights.near_bounds(), joined;
    std::erase_if(lamps, [](const LightBounds& lamp) { return !(lamp.intensity > 0.0); });
    if (lamps.size() <= kMostNear)
        joined = std::move(lamps);
    else
        join_neighbours(std::move(lamps), kMostNear, joined);
    for (const LightBounds& lamp : joined) add(lamp);
    for (const Light& light : scene.lights)
        if (const auto* beam = std::get_if<BeamLight>(&light))
            beams_.push_back({beam->position.v, beam->direction.v, beam->radius.to(unit::m),
                              brightness(*beam->irradiance)});
}

void HazeLamps::add(const LightBounds& lamp) {
    Near near{lamp.box.centre(), lamp.box.radius(), lamp.intensity, true, {}, {}, 0.0};
    const double half_angle =
        (lamp.normals.half_angle_rad + lamp.emission_rad) * kWider + kWider_rad;
    if (!lamp.two_sided && half_angle <= kPi / 2.0 * kWider + kWider_rad) {
        near.everywhere = false;
        near.axis = lamp.normals.axis;
        near.cosine = std::max(0.0, std::cos(half_angle));
        // The cones of all points of the ball lie in this one.
        near.apex = near.centre - near.axis * (near.radius / std::sin(half_angle));
    }
    near_.push_back(near);
}

DistanceDensity HazeLamps::density(Vec3 origin, Vec3 direction, double length,
                                   std::span<const double> extinction) const {
    DistanceDensity density(extinction);
    const RayInterval all{0.0, length};
    density.add_attenuated(all, far_irradiance_);
    add_near(origin, direction, length, density);
    density.finish(all, kEvenShare);
    return density;
}

DistanceDensity HazeLamps::near_density(Vec3 origin, Vec3 direction, double length,
                                        std::span<const double> extinction) const {
    DistanceDensity density(extinction);
    if (near_.empty() && beams_.empty()) return density;
    add_near(origin, direction, length, density);
    density.finish({0.0, length}, kEvenShare);
    return density;
}

void HazeLamps::add_near(Vec3 origin, Vec3 direction, double length,
                         DistanceDensity& density) const {
    const RayInterval all{0.0, length};
    for (const Near& lamp : near_) {
        const RayInterval lit = lamp.everywhere ? all
                                                : part_in_cone(origin, direction, length, lamp.apex,
                                                               lamp.axis, lamp.cosine);
        if (lit.empty()) continue;
        const Vec3 to_lamp = lamp.centre - origin;
        const double centre = dot(to_lamp, direction);
        const Vec3 aside = to_lamp - direction * centre;
        // Near a lamp of some size irradiance grows no further: it is as of a point beside it.
        const double width = std::sqrt(dot(aside, aside) + lamp.radius * lamp.radius);
        density.add_equiangular(lit, centre, width, lamp.intensity);
    }
    for (const Cylinder& beam : beams_)
        density.add_attenuated(
            part_in_cylinder(origin, direction, length, beam.base, beam.axis, beam.radius),
            beam.irradiance);
}

}  // namespace dewbow
