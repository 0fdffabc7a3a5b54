// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "dewbow/render/path/tracer.h"

namespace dewbow::path_tracing {

namespace {

double power_heuristic(double a, double b) { return a * a / (a * a + b * b); }

}  // namespace

void Tracer::add(const LaneSet& lanes, const LaneValues& beta, const LaneValues& radiance,
                 double weight, MediaStack media) {
    const int medium = media.interior();
    if (medium == start_medium_) {
        for (int k = 0; k < lanes.count; ++k)
            result_.radiance[std::size_t(lanes.id[std::size_t(k)])] +=
                weight * beta[k] * radiance[k];
        return;
    }
    const auto& here = packet_media_.index(medium);
    const auto& start = packet_media_.index(start_medium_);
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        const double ratio = start[id] / here[id];
        result_.radiance[id] += weight * beta[k] * radiance[k] * ratio * ratio;
    }
}

void Tracer::add_infinite(const LaneSet& lanes, const LaneValues& beta, Vec3 direction,
                          bool specular, double pdf, const Receiver& from, MediaStack media) {
    const LightSet& lights = prepared_.lights;
    LaneValues radiance;
    for (int i = 0; i < lights.infinite_count(); ++i) {
        if (!lights.infinite_radiance(i, direction, lanes, rgb_.light, radiance)) continue;
        const double weight =
            specular ? 1.0 : power_heuristic(pdf, lights.pdf_of_infinite(from, i, direction));
        add(lanes, beta, radiance, weight, media);
    }
}

void Tracer::add_emission(const LaneSet& lanes, const LaneValues& beta, const Ray& ray,
                          const Hit& hit, bool specular, double pdf, const Receiver& from,
                          MediaStack media) {
    LaneValues radiance;
    const LightSet& lights = prepared_.lights;
    SurfaceCoordinates at;
    if (lights.emission_varies(hit))
        at = prepared_.accelerator.coordinates(hit, ray.origin + ray.direction * hit.t);
    lights.emission(hit, at, lanes, rgb_.light, radiance);
    double weight = 1.0;
    if (!specular) {
        Hit seen_from = hit;
        seen_from.t = length(ray.origin + ray.direction * hit.t - from.position);
        weight = power_heuristic(pdf, lights.pdf_of_hit(from, ray.direction, seen_from));
    }
    add(lanes, beta, radiance, weight, media);
}

/// Direct light at `vertex`. `eval(wi, f)` gives BSDF × cosine at each lane and returns the density
/// of the surface's own sampling.
template <class Eval>
void Tracer::direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides,
                          Eval&& eval) {
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
    prepared_.lights.radiance(*light, path.lanes, rgb_.light, radiance);
    for (int k = 0; k < path.lanes.count; ++k) radiance[k] *= f[k];
    // What is infinitely far is not absorbed, as where a path misses everything.
    if (std::isfinite(light->distance)) absorb(path.lanes, radiance, path.media, light->distance);
    const double weight = light->without_extent ? 1.0 : power_heuristic(light->pdf, pdf);
    add(path.lanes, path.beta, radiance, weight / light->pdf, path.media);
}

void Tracer::direct_scattered(const SharedPath& path, const Vertex& vertex, const LocalFrame& frame,
                              const ScatteringSurface& surface, const Material& material) {
    const bool both_sides = ScatteringSurface::transmits(material);
    direct_light(path, vertex, both_sides, [&](Vec3 direction, LaneValues& f) {
        const Vec3 wi = frame.to_local(direction);
        const bool above = dot(direction, vertex.geometric) > 0.0;
        return (wi.z > 0.0) == above ? surface.eval(wi, f) : 0.0;
    });
}

/// Of one lane.
void Tracer::direct_rough(const SharedPath& path, const Vertex& vertex, const LocalFrame& frame,
                          const RoughDielectric& surface, const Dielectric& glass,
                          const Boundary& boundary) {
    SharedPath there = path;
    direct_light(there, vertex, true, [&](Vec3 direction, LaneValues& f) {
        const Vec3 wi = frame.to_local(direction);
        const bool above = dot(direction, vertex.geometric) > 0.0;
        if ((wi.z > 0.0) != above) return 0.0;
        there.media = above ? boundary.before : boundary.after;
        const RoughDielectric::Value value = surface.eval(wi);
        f[0] = value.f_cos;
        if (!above) tint(glass.tint, vertex, path.lanes, f);
        return value.pdf;
    });
}

}  // namespace dewbow::path_tracing
