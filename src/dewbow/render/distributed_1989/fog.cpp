// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/ray_tree.h"

namespace dewbow::distributed_1989 {

/// "Red, green, and blue values at ray endpoints are replaced at independent rates per unit
/// distance": those of every ray through the surroundings, but for shadow rays.        [4.3.2]
void RayTree::look_through_fog(TracedRay& ray, RayFamily& family, const Hit& hit,
                               MonitorRgb& sum) const {
    const std::uint32_t at = vertex_key(ray) + std::uint32_t(ray.passed) * 0x85ebca6bu;
    const auto u = key_.two(at, Purpose::paper_fog);
    const Vec3 direction = ray.ray.direction;
    if (method_.carries_rgb()) {
        const auto share = prepared_.paper_fog->fog().on_ray({direction}, hit.t * unit::m, u);
        if (share) fog_in_channels(ray, family, *share, sum);
        return;
    }
    const BandValues arriving = ray.beta;
    for (BandBlock& block : family.bands.blocks()) {
        FogVeil veil;
        if (!prepared_.paper_fog->on_ray(direction, hit.t, u, block.lanes, block.reflectance,
                                         block.light, veil))
            return;
        sum = sum + family.bands.sum(block, arriving, veil.light);
        for (int k = 0; k < block.lanes.count; ++k)
            ray.beta[block.first + k] *= 1.0 - veil.replaced[k];
    }
}

/// The three numbers themselves.
void RayTree::fog_in_channels(TracedRay& ray, RayFamily& family, const PaperFog::Share& share,
                              MonitorRgb& sum) const {
    LaneValues light;
    for (int c = 0; c < 3; ++c) {
        const auto i = std::size_t(c);
        light[c] = share.replaced[i] * share.colour[i] * prepared_.paper_fog->white();
    }
    sum = sum + family.bands.sum(family.bands.blocks().front(), ray.beta, light);
    for (int c = 0; c < 3; ++c) ray.beta[c] *= 1.0 - share.replaced[std::size_t(c)];
}

}  // namespace dewbow::distributed_1989
