// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/accelerator.h"

#include <embree3/rtcore.h>

#include <cmath>

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

Vec3 Accelerator::shading_normal(const Hit& hit) const {
    if (flat(hit.shape)) return hit.normal;
    const WorldMesh& mesh =
        tree_->meshes[std::size_t(tree_->mesh_of_shape[std::size_t(hit.shape)])];
    const auto& [a, b, c] = (*mesh.triangles)[std::size_t(hit.primitive)];
    const Vec3 n =
        mesh.normals[a] * (1.0 - hit.u - hit.v) + mesh.normals[b] * hit.u + mesh.normals[c] * hit.v;
    const double squared = dot(n, n);
    if (!(squared > 0.0) || dot(n, hit.normal) <= 0.0) return hit.normal;
    return n / std::sqrt(squared);
}

bool Accelerator::flat(int shape) const {
    const int which = tree_->mesh_of_shape[std::size_t(shape)];
    return which < 0 || tree_->meshes[std::size_t(which)].normals.empty();
}

std::string accelerator_fingerprint() {
    return std::string("Embree ") + RTC_VERSION_STRING + " " + embree_isa();
}

}  // namespace dewbow
