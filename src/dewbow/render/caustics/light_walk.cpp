// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/light_walk.h"

#include <algorithm>
#include <cmath>

namespace dewbow::caustics {

using walk::RoughGlass;
using walk::Scatterer;
using walk::SharedPath;

LightWalk::LightWalk(const PreparedScene& prepared, const LightPaths& light_paths,
                     const WavelengthPacket& packet, const SampleKey& key, SplatList& splats)
    : PacketWalk(walk::Start::lamp, prepared, packet, key),
      light_paths_(light_paths),
      splats_(splats) {}

void LightWalk::run(const EmittedRay& emitted, MediaStack media) {
    emitted_ = &emitted;
    density_ = emitted.pdf;
    SharedPath path = shared_start(emitted.ray, media);
    path.from_afar = emitted.source == LightSample::Source::infinite;
    light_paths_.emission.radiance(emitted, path.lanes, light_colours(), source_);
    for (int k = 0; k < path.lanes.count; ++k) source_[k] /= emitted.pdf;
    follow(path);
}

bool LightWalk::on_scatterer(const SharedPath& path, const Scatterer& at) {
    if (path.sees_start()) return false;
    if (!prepared_.camera.disperses()) {
        splat(path, at);
        return true;
    }
    SharedPath lane = path;  // the lens sends each lane to a place of its own
    for (int k = 0; k < path.lanes.count; ++k) {
        lane.lanes = LaneSet::one(packet_, path.lanes.id[std::size_t(k)]);
        lane.beta[0] = path.beta[k];
        splat(lane, at);
    }
    return true;
}

/// Lanes that one point of the lens sees at one place.
void LightWalk::splat(const SharedPath& path, const Scatterer& at) {
    const auto u_lens = key_.two(vertex_key(path.depth, path.branch), Purpose::lens);
    std::array<Seen, 2> seen;
    const int eyes =
        prepared_.camera.seen(at.vertex.position, u_lens, path.lanes.lambda_nm[0], seen);
    for (int i = 0; i < eyes; ++i) splat(path, at, seen[std::size_t(i)]);
}

/// With Φ the light that the path stands for: Φ f(c, l) |cos θ_l'| J |cos θ_c| / |cos θ_l|, where
/// θ_l' is the angle to the shading normal. All that is asked of the surface is asked as a path
/// from the camera asks it, so that both agree where shading normals make a difference.
void LightWalk::splat(const SharedPath& path, const Scatterer& at, const Seen& seen) {
    const Vertex y1 = vertex_from(prepared_, at.vertex.position, seen.direction, at.hit);
    const double cos_camera = dot(seen.direction, y1.geometric);
    const double cos_light = dot(at.vertex.wo, y1.geometric);
    const bool above = cos_light > 0.0;
    if (!(cos_camera > 0.0) || (!above && !ScatteringSurface::transmits(at.material))) return;
    const LocalFrame frame(y1.shading);
    const Vec3 wi = frame.to_local(at.vertex.wo);
    if ((wi.z > 0.0) != above) return;
    if (prepared_.accelerator.occluded(y1.leave(seen.direction), seen.distance)) return;
    const ScatteringSurface surface =
        surface_at(path.lanes, prepared_.camera_media, y1, frame, at.material);
    LaneValues value;
    surface.eval(wi, value);
    const double ratio = density_ * light_ratio(light_paths_, std::abs(cos_light), cos_camera,
                                                seen.pixels_per_m2, surface.typical_density(wi));
    const double factor =
        seen.pixels_per_m2 * cos_camera / std::abs(cos_light) * weight(path.note, ratio);
    for (int k = 0; k < path.lanes.count; ++k)
        value[k] *= path.beta[k] * source_[path.lanes.id[std::size_t(k)]] * factor;
    absorb(
        shadow_way(y1.position, seen.direction, seen.distance, vertex_key(path.depth, path.branch)),
        path.lanes, value, prepared_.camera_media);
    look_through_fog(-seen.direction, seen.distance, path, path.lanes, value);
    const SplatLight light(packet_, path.lanes, value);
    prepared_.camera.for_each_pixel(
        seen, [&](int x, int y, double density) { splats_.add(x, y, density, light); });
}

/// As the camera does, where the paper's rainbow stands before what it sees (CameraWalk::on_sight).
void LightWalk::look_through_fog(Vec3 direction, double distance, const SharedPath& path,
                                 const LaneSet& lanes, LaneValues& value) {
    if (!prepared_.paper_fog || prepared_.camera_media.interior() != 0) return;
    FogVeil veil;
    const auto u = key_.two(flight_key(path), Purpose::paper_fog);
    if (!prepared_.paper_fog->on_ray(direction, distance, u, lanes, share_colours(),
                                     light_colours(), veil))
        return;
    for (int k = 0; k < lanes.count; ++k) value[k] *= 1.0 - std::min(veil.replaced[k], 1.0);
}

double LightWalk::weight(double note, double ratio) const {
    const double chance = emitted_->without_extent ? 0.0 : 1.0;
    return weight_of_light(ratio, chance + note * note);
}

/// Where the lamp's ray first meets rough glass, camera paths take direct light too, unless
/// they cannot go on that way.
void LightWalk::on_rough_turn(SharedPath& lane, const RoughGlass& at) {
    if (!lane.sees_start()) return;
    const Vertex vertex = vertex_from(prepared_, at.vertex.position, lane.ray.direction, at.hit);
    const LocalFrame frame(vertex.shading);
    const Vec3 wo = frame.to_local(vertex.wo);
    const bool reflects = vertex.front == at.vertex.front;
    const RoughDielectric seen(wo, at.alpha, reflects ? at.eta : 1.0 / at.eta);
    const double chance = seen.eval(frame.to_local(at.vertex.wo)).pdf;
    const double direct = density_of_direct(at.vertex.position);
    lane.note = chance > 0.0 ? direct / chance : 0.0;
}

/// With which direct light at `receiver` takes the lamp's ray backwards.
double LightWalk::density_of_direct(Vec3 receiver) {
    const LightSet& lights = prepared_.lights;
    const EmittedRay& emitted = *emitted_;
    const Vec3 direction = -emitted.ray.direction;
    const Receiver from{receiver};
    const double distance = length(emitted.ray.origin - receiver);
    if (emitted.without_extent) {
        const double choice = lights.pdf_of_choice(from, emitted.source, emitted.index);
        LightSample sample{emitted.source, emitted.index, direction, distance, choice};
        sample.without_extent = true;
        density_ = light_paths_.emission.density_of_sample(sample, receiver);
        return choice_by_extent(emitted.source, choice, distance);
    }
    if (emitted.source == LightSample::Source::infinite)
        return lights.pdf_of_infinite(from, emitted.index, direction);
    const GlowingShape& shape = lights.shapes()[std::size_t(emitted.index)];
    Hit hit;
    hit.t = distance;
    hit.shape = emitted.ray.from.shape, hit.primitive = emitted.ray.from.primitive;
    hit.normal = shape.normal_at(emitted.ray.origin, hit.primitive);
    return lights.pdf_of_hit(from, direction, hit);
}

}  // namespace dewbow::caustics
