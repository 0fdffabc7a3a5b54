// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/distant_emission.h"

#include <algorithm>
#include <cmath>

namespace dewbow::caustics {

DistantEmission::DistantEmission(const InfiniteLight& light, int index, const Aims& aims)
    : GroupedEmission(LightSample::Source::infinite, index, aims, 0),
      light_(light),
      outside_(aims.outside) {
    double area = 0.0;  // of their mean shadow
    for (const CasterBounds& group : groups())
        if (!group.endless()) area += 0.25 * group.surface();
    const bool endless = std::any_of(groups().begin(), groups().end(),
                                     [](const CasterBounds& g) { return g.endless(); });
    weigh(groups().size(), std::vector<bool>(groups().size(), false),
          light.irradiance() * (endless ? std::max(area, 1.0) : area));
}

std::optional<EmittedRay> DistantEmission::towards(int target,
                                                   const std::array<double, 4>& u) const {
    const auto far = light_.sample({u[2], u[3]});
    if (!far) return std::nullopt;
    const Vec3 direction = -far->direction;
    const auto entry = groups()[std::size_t(target)].enter(direction, {u[0], u[1]});
    if (!entry) return std::nullopt;
    return lit({outside_.before(entry->point, direction), direction, {}}, far->pdf * entry->pdf,
               light_.parallel());
}

std::optional<EmissionMap::Place> DistantEmission::place_towards(int target, const Ray& ray) const {
    const auto entry = groups()[std::size_t(target)].entry_of(ray.origin, ray.direction);
    if (!entry) return std::nullopt;
    if (light_.parallel()) return Place{{entry->u[0], entry->u[1], 0.5, 0.5}, entry->pdf};
    const Vec3 towards_light = -ray.direction;
    if (!light_.shows(towards_light)) return std::nullopt;
    const auto far = light_.place_of(towards_light);
    return Place{{entry->u[0], entry->u[1], far[0], far[1]},
                 entry->pdf * light_.pdf(towards_light)};
}

double DistantEmission::brightness(const EmittedRay& ray) const {
    return light_.brightness(-ray.ray.direction);
}

}  // namespace dewbow::caustics
