// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/render/distributed_1989/ray_tree.h"

namespace dewbow::distributed_1989 {

namespace {

/// Surfaces are looked at from above, if only by rounding.
constexpr double kLeastCosineSeen = 1e-12;

/// From this metalness on a surface of glTF shows what it mirrors.
constexpr double kGlossyMetalness = 0.5;

bool is_glossy(const Material& material, const SurfaceCoordinates& at) {
    if (const auto* layered = std::get_if<MetallicRoughness>(&material.surface))
        return number_at(layered->metalness, at) >= kGlossyMetalness;
    return std::holds_alternative<Conductor>(material.surface) ||
           std::holds_alternative<ThinDielectric>(material.surface);
}

/// A surface as the bands of one block see it.
class BlockSurface {
public:
    BlockSurface(BandBlock& block, MediaStack media, const Vertex& vertex, const LocalFrame& frame,
                 const Material& material)
        : inputs_(vertex.at, block.reflectance),
          outside_(block.indices(media.interior())),
          surface_(material, {inputs_, block.lanes, outside_, local_wo(vertex, frame)}) {}

    const ScatteringSurface& operator*() const { return surface_; }
    const ScatteringSurface* operator->() const { return &surface_; }

private:
    static Vec3 local_wo(const Vertex& vertex, const LocalFrame& frame) {
        Vec3 wo = frame.to_local(vertex.wo);
        wo.z = std::max(wo.z, kLeastCosineSeen);
        return wo;
    }

    SurfaceInputs inputs_;
    LaneValues outside_;
    ScatteringSurface surface_;
};

}  // namespace

void RayTree::add_lamp(const TracedRay& ray, RayFamily& family, const Hit& hit,
                       MonitorRgb& sum) const {
    const LightSet& lights = prepared_.lights;
    SurfaceCoordinates at;
    if (lights.emission_varies(hit))
        at = prepared_.accelerator.coordinates(hit, ray.ray.origin + ray.ray.direction * hit.t);
    for (BandBlock& block : family.bands.blocks()) {
        LaneValues radiance;
        lights.emission(hit, at, block.lanes, block.light, radiance);
        sum = sum + family.bands.sum(block, ray.beta, radiance);
    }
}

void RayTree::add_infinite(const TracedRay& ray, RayFamily& family, MonitorRgb& sum) const {
    const LightSet& lights = prepared_.lights;
    for (int i = 0; i < lights.infinite_count(); ++i) {
        for (BandBlock& block : family.bands.blocks()) {
            LaneValues radiance;
            if (!lights.infinite_radiance(i, ray.ray.direction, block.lanes, block.light, radiance))
                break;
            sum = sum + family.bands.sum(block, ray.beta, radiance);
        }
    }
}

/// Something rough: light from a lamp, and of what is glossy one ray more.
bool RayTree::scatter(const Meeting& at, const Material& material) const {
    const LocalFrame frame(at.vertex.shading);
    direct_light(at, frame, material);
    return is_glossy(material, at.vertex.at) && gloss(at, frame, material);
}

void RayTree::direct_light(const Meeting& at, const LocalFrame& frame,
                           const Material& material) const {
    const Vertex& vertex = at.vertex;
    const bool both_sides = ScatteringSurface::transmits(material);
    const std::uint32_t key = vertex_key(at.ray);
    const std::optional<LightSample> light =
        prepared_.lights.sample(vertex.receiver(both_sides), key_.one(key, Purpose::light_choice),
                                key_.two(key, Purpose::light_point));
    if (!light || !(light->pdf > 0.0)) return;
    const double side = dot(light->direction, vertex.geometric);
    const Vec3 wi = frame.to_local(light->direction);
    if (side == 0.0 || (side < 0.0 && !both_sides) || (wi.z > 0.0) != (side > 0.0)) return;
    if (prepared_.accelerator.occluded(vertex.leave(light->direction), light->distance)) return;
    BandValues arriving = at.ray.beta;
    // What is infinitely far is not absorbed, as where a ray misses everything.
    if (std::isfinite(light->distance)) absorb(at.family, arriving, at.ray.media, light->distance);
    for (BandBlock& block : at.family.bands.blocks()) {
        LaneValues radiance, f;
        prepared_.lights.radiance(*light, block.lanes, block.light, radiance);
        if (!(BlockSurface(block, at.ray.media, vertex, frame, material)->eval(wi, f) > 0.0))
            return;
        for (int k = 0; k < block.lanes.count; ++k) radiance[k] *= f[k] / light->pdf;
        at.sum = at.sum + at.family.bands.sum(block, arriving, radiance);
    }
}

/// Turns the ray to where the surface mirrors most. Lamps have been counted.
bool RayTree::gloss(const Meeting& at, const LocalFrame& frame, const Material& material) const {
    const std::uint32_t key = vertex_key(at.ray);
    auto& blocks = at.family.bands.blocks();
    const BlockSurface first(blocks.front(), at.ray.media, at.vertex, frame, material);
    const std::optional<Vec3> wi =
        first->sample(key_.one(key, Purpose::bsdf_lobe), key_.two(key, Purpose::bsdf_direction));
    if (!wi) return false;
    const Vec3 direction = frame.to_world(*wi);
    LaneValues f;
    const double pdf = first->eval(*wi, f);
    if (!(pdf > 0.0) || (dot(direction, at.vertex.geometric) > 0.0) != (wi->z > 0.0)) return false;
    for (BandBlock& block : blocks) {
        BlockSurface(block, at.ray.media, at.vertex, frame, material)->eval(*wi, f);
        for (int k = 0; k < block.lanes.count; ++k) at.ray.beta[block.first + k] *= f[k] / pdf;
    }
    at.ray.ray = at.vertex.leave(direction);
    at.ray.sees_lamps = false;
    ++at.ray.depth;
    return true;
}

}  // namespace dewbow::distributed_1989
