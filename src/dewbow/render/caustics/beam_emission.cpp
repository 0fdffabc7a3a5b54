// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/beam_emission.h"

#include <numbers>

#include "dewbow/render/brightness.h"

namespace dewbow::caustics {

BeamEmission::BeamEmission(const Beam& beam, int index, const Aims& aims)
    : GroupedEmission(LightSample::Source::beam, index, aims, 0),
      beam_(beam.light()),
      disc_{beam_.position.v, beam_.radius.to(unit::m)},
      brightness_(dewbow::brightness(beam.spectrum())) {
    const double area = std::numbers::pi * disc_.radius * disc_.radius;
    double all = 0.0;
    for (const CasterBounds& group : groups()) {
        const auto entry = group.enter(beam_.direction.v, {0.5, 0.5});
        const bool smaller = !group.endless() && entry && 1.0 / entry->pdf < area;
        by_group_.push_back(smaller);
        all += smaller ? 1.0 / entry->pdf : area;
    }
    if (all >= area && !groups().empty()) by_group_.assign(1, false);
    weigh(by_group_.size(), std::vector<bool>(by_group_.size(), false), brightness_ * area);
}

Vec3 BeamEmission::start_of(Vec3 point) const {
    return point - beam_.direction.v * dot(point - disc_.centre, beam_.direction.v);
}

bool BeamEmission::carries(Vec3 start) const {
    const Vec3 aside = start - disc_.centre;
    return dot(aside, aside) <= disc_.radius * disc_.radius;
}

std::optional<EmittedRay> BeamEmission::towards(int target, const std::array<double, 4>& u) const {
    const Vec3 direction = beam_.direction.v;
    const auto entry = by_group_[std::size_t(target)]
                           ? groups()[std::size_t(target)].enter(direction, {u[0], u[1]})
                           : CasterBounds(disc_).enter(direction, {u[0], u[1]});
    if (!entry) return std::nullopt;
    const Vec3 start = start_of(entry->point);
    if (!carries(start)) return std::nullopt;
    return lit({start, direction, {}}, entry->pdf, true);
}

std::optional<EmissionMap::Place> BeamEmission::place_towards(int target, const Ray& ray) const {
    const Vec3 start = start_of(ray.origin);
    if (!carries(start)) return std::nullopt;
    const auto place = by_group_[std::size_t(target)]
                           ? groups()[std::size_t(target)].entry_of(start, beam_.direction.v)
                           : CasterBounds(disc_).entry_of(start, beam_.direction.v);
    if (!place) return std::nullopt;
    return Place{{place->u[0], place->u[1], 0.5, 0.5}, place->pdf};
}

double BeamEmission::brightness(const EmittedRay&) const { return brightness_; }

}  // namespace dewbow::caustics
