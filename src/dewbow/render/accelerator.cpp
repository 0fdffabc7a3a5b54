// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/accelerator.h"

#include <embree3/rtcore.h>

#include "dewbow/render/accelerator_tree.h"

namespace dewbow {

Accelerator::Accelerator(const Scene& scene, std::vector<bool> see_through, const Opacity* opacity)
    : tree_(std::make_unique<AcceleratorTree>(scene, std::move(see_through), opacity)) {}

Accelerator::~Accelerator() = default;

Hit Accelerator::intersect(const Ray& ray) const {
    RayLanes rays;
    rays.count = 1;
    rays.set(0, ray);
    Hit hit;
    tree_->intersect(rays, 1u, std::span(&hit, 1));
    return hit;
}

void Accelerator::intersect(const RayLanes& rays, LaneMask mask, HitLanes& hits) const {
    tree_->intersect(rays, mask, hits);
}

bool Accelerator::occluded(const Ray& ray, double distance) const {
    return tree_->occluded(ray, distance);
}

std::string accelerator_fingerprint() {
    return std::string("Embree ") + RTC_VERSION_STRING + " " + embree_isa();
}

}  // namespace dewbow
