// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>

#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

using caustics::power_heuristic;

/// `radiance` that arrives at the end of the path. What it carries is divided by the square of the
/// index; the factor is put back here.
void CameraWalk::add(const SharedPath& path, const LaneValues& radiance, double weight) {
    const LaneSet& lanes = path.lanes;
    const int medium = path.media.interior();
    if (medium == start_.interior()) {
        for (int k = 0; k < lanes.count; ++k)
            result_.radiance[std::size_t(lanes.id[std::size_t(k)])] +=
                weight * path.beta[k] * radiance[k];
        return;
    }
    const auto& here = packet_media().index(medium);
    const auto& start = packet_media().index(start_.interior());
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        const double ratio = start[id] / here[id];
        result_.radiance[id] += weight * path.beta[k] * radiance[k] * ratio * ratio;
    }
}

/// Whether light paths can find the light that the path has run into.
bool CameraWalk::shared_with_light(const SharedPath& path) {
    return path.note > 0.0 && (path.last.specular || path.last.rough_glass);
}

/// @param next_event  density of direct light for the same direction; 0 if it cannot take it.
/// @param density  of the lamp's ray, with which light paths start; 0 if they cannot.
double CameraWalk::weight_of_chance(const SharedPath& path, double next_event, double density) {
    const double chance = path.last.specular ? 1.0 : path.last.pdf;
    return power_heuristic(chance, next_event, density > 0.0 ? chance * path.note * density : 0.0);
}

/// Whether the light of what the path has run into was found before: at the drop that turned it.
bool CameraWalk::found_at_drop(const SharedPath& path) {
    return path.last.drop && !path.last.specular;
}

void CameraWalk::on_leaving(const SharedPath& path) {
    if (found_at_drop(path)) return;
    const LightSet& lights = prepared_.lights;
    const LastTurn& last = path.last;
    LaneValues radiance;
    for (int i = 0; i < lights.infinite_count(); ++i) {
        const Vec3 direction = path.ray.direction;
        if (!lights.infinite_radiance(i, direction, path.lanes, light_colours(), radiance))
            continue;
        const double next_event =
            last.specular ? 0.0 : lights.pdf_of_infinite(last.receiver, i, direction);
        const double density =
            shared_with_light(path) ? light_paths_->emission.density_of_infinite(i, path.ray) : 0.0;
        add(path, radiance, weight_of_chance(path, next_event, density));
    }
}

void CameraWalk::on_lamp(const SharedPath& path, const Hit& hit) {
    if (found_at_drop(path)) return;
    const LightSet& lights = prepared_.lights;
    const Vec3 position = path.ray.origin + path.ray.direction * hit.t;
    LaneValues radiance;
    SurfaceCoordinates at;
    if (lights.emission_varies(hit)) at = prepared_.accelerator.coordinates(hit, position);
    lights.emission(hit, at, path.lanes, light_colours(), radiance);
    double next_event = 0.0;
    if (!path.last.specular) {
        Hit seen_from = hit;
        seen_from.t = length(position - path.last.receiver.position);
        next_event = lights.pdf_of_hit(path.last.receiver, path.ray.direction, seen_from);
    }
    const double density = shared_with_light(path)
                               ? light_paths_->emission.density_of_hit(hit, position, path.ray)
                               : 0.0;
    add(path, radiance, weight_of_chance(path, next_event, density));
}

/// @param chance  density of running into the light, per sr.
double CameraWalk::weight_of_direct(const LightSample& light, Vec3 receiver, double chance,
                                    double note) const {
    const double by_light =
        note > 0.0 ? chance * note * light_paths_->emission.density_of_sample(light, receiver)
                   : 0.0;
    if (!light.without_extent) return power_heuristic(light.pdf, chance, by_light);
    return power_heuristic(caustics::choice_by_extent(light.source, light.pdf, light.distance), 0.0,
                           by_light);
}

/// Direct light at `vertex`. `eval(wi, f)` gives BSDF × cosine at each lane and returns the density
/// of the surface's own sampling.   @param note  the path's, if light paths may come this way.
template <class Eval>
void CameraWalk::direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides,
                              double note, Eval&& eval) {
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const std::optional<LightSample> light =
        prepared_.lights.sample(vertex.receiver(both_sides), key_.one(at, Purpose::light_choice),
                                key_.two(at, Purpose::light_point));
    if (!light || !(light->pdf > 0.0)) return;
    const double side = dot(light->direction, vertex.geometric);
    if (side == 0.0 || (side < 0.0 && !both_sides)) return;
    LaneValues f{};
    const double pdf = eval(light->direction, f);
    if (!(pdf > 0.0)) return;
    if (prepared_.accelerator.occluded(vertex.leave(light->direction), light->distance)) return;
    LaneValues radiance;
    prepared_.lights.radiance(*light, path.lanes, light_colours(), radiance);
    for (int k = 0; k < path.lanes.count; ++k) radiance[k] *= f[k];
    absorb(shadow_way(vertex.position, light->direction, light->distance, at), path.lanes, radiance,
           path.media);
    add(path, radiance, weight_of_direct(*light, vertex.position, pdf, note) / light->pdf);
}

bool CameraWalk::on_scatterer(const SharedPath& path, const Scatterer& at) {
    const bool both_sides = ScatteringSurface::transmits(at.material);
    direct_light(path, at.vertex, both_sides, 0.0, [&](Vec3 direction, LaneValues& f) {
        const Vec3 wi = at.frame.to_local(direction);
        const bool above = dot(direction, at.vertex.geometric) > 0.0;
        return (wi.z > 0.0) == above ? at.surface.eval(wi, f) : 0.0;
    });
    return true;
}

void CameraWalk::on_rough_glass(const SharedPath& lane, const RoughGlass& at) {
    SharedPath there = lane;
    direct_light(there, at.vertex, true, lane.note, [&](Vec3 direction, LaneValues& f) {
        const Vec3 wi = at.frame.to_local(direction);
        const bool above = dot(direction, at.vertex.geometric) > 0.0;
        if ((wi.z > 0.0) != above) return 0.0;
        there.media = above ? at.boundary.before : at.boundary.after;
        const RoughDielectric::Value value = at.surface.eval(wi);
        f[0] = value.f_cos;
        if (!above) tint(at.glass.tint, at.vertex, lane.lanes, f);
        return value.pdf;
    });
}

}  // namespace dewbow::walk
