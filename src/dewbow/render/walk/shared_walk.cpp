// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::walk {

namespace {

/// Boundaries that are none (between equal media, inside overlaps) passed at one go before a path
/// is given up: more than any real scene nests.
constexpr int kMostPassed = 64;

/// Surfaces are looked at from above, if only by rounding.
constexpr double kLeastCosineSeen = 1e-12;

}  // namespace

SharedPath PacketWalk::shared_start(const Ray& ray, MediaStack media) const {
    SharedPath path;
    path.ray = ray;
    path.lanes = LaneSet::all(packet_);
    path.beta.v.fill(1.0);
    path.media = media;
    return path;
}

void PacketWalk::follow(const SharedPath& path) {
    trace(path);
    finish_pending();
}

void PacketWalk::finish_pending() {
    while (!memory_.pending.empty()) {
        const SharedPath next = memory_.pending.back();
        memory_.pending.pop_back();
        trace(next);
    }
}

void PacketWalk::trace(SharedPath path) {
    for (;;) {
        const Hit hit = prepared_.accelerator.intersect(path.ray);
        if (sees_fog(path.media, path.scattered)) on_sight(path, hit);
        if (scatters(path.media, path.depth)) on_flight(path, hit);
        if (may_meet_drops(path)) {
            const Flight flight = fly_in_rain(path, hit);
            if (flight == Flight::ended) return;
            if (flight == Flight::turned) continue;
        }
        if (hit || !path.from_afar) absorb(flight(path, hit), path.lanes, path.beta, path.media);
        path.from_afar = false;
        if (!hit) {
            on_leaving(path);
            return;
        }
        if (prepared_.lights.emits(hit, path.ray.direction)) on_lamp(path, hit);
        const int depth = path.depth;
        if (depth >= settings_.max_depth || !interact(path, hit)) return;
        // A surface that is none costs no depth, and its random numbers were used before it.
        if (path.depth == depth) continue;
        path.passed = 0;
        const LaneMask all = (1u << path.lanes.count) - 1u;
        if (!roulette(path.beta, path.lanes.count, all, path.depth,
                      vertex_key(path.depth, path.branch)))
            return;
    }
}

/// Takes the path past one surface. False: it ends here.
bool PacketWalk::interact(SharedPath& path, const Hit& hit) {
    const Vertex vertex = vertex_at(path.ray, hit);
    const int id = material_at(path.ray, hit, flight_key(path));
    const Material& material = this->material(id);
    on_surface(path, vertex, id);
    if (const auto* glass = std::get_if<Dielectric>(&material.surface))
        return is_rough(*glass) ? rough(path, hit, *glass, prepared_.media.interior_of(id))
                                : smooth(path, vertex, *glass, prepared_.media.interior_of(id));
    if (ScatteringSurface::holds(material)) return scatter(path, hit, vertex, material, true);
    if (const auto* m = std::get_if<Mirror>(&material.surface)) return mirror(path, vertex, *m);
    if (const auto* c = std::get_if<Conductor>(&material.surface)) return metal(path, vertex, *c);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return thin(path, vertex, *pane);
    return false;
}

ScatteringSurface PacketWalk::surface_at(const LaneSet& lanes, MediaStack media,
                                         const Vertex& vertex, const LocalFrame& frame,
                                         const Material& material) {
    LaneValues outside;
    index_around(lanes, media, outside);
    Vec3 wo = frame.to_local(vertex.wo);
    wo.z = std::max(wo.z, kLeastCosineSeen);
    return {material, {inputs_at(vertex), lanes, outside, wo}};
}

bool PacketWalk::scatter(SharedPath& path, const Hit& hit, const Vertex& vertex,
                         const Material& material, bool show) {
    const LocalFrame frame(vertex.shading);
    const ScatteringSurface surface = surface_at(path.lanes, path.media, vertex, frame, material);
    const Scatterer scatterer{hit, vertex, frame, material, surface};
    if (show && !on_scatterer(path, scatterer)) return false;
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const std::optional<Vec3> wi =
        surface.sample(key_.one(at, Purpose::bsdf_lobe), key_.two(at, Purpose::bsdf_direction));
    if (!wi) return false;
    LaneValues f;
    const double pdf = surface.eval(*wi, f);
    const Vec3 direction = frame.to_world(*wi);
    const bool above = dot(direction, vertex.geometric) > 0.0;
    if (!(pdf > 0.0) || above != (wi->z > 0.0)) return false;
    const double factor = shading_factor(vertex, vertex.shading, direction);
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= f[k] / pdf * factor;
    path.ray = vertex.leave(direction);
    path.scattered = true;
    path.last = {false, pdf, vertex.receiver(ScatteringSurface::transmits(material)), false};
    on_scattered(path, scatterer, *wi);
    ++path.depth;
    return true;
}

/// Sends the path on along `direction`, from a smooth surface that has this normal for light.
void PacketWalk::turn(SharedPath& path, const Vertex& vertex, Vec3 normal, Vec3 direction) const {
    const double factor = shading_factor(vertex, normal, direction);
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= factor;
    path.ray = vertex.leave(direction);
    path.last.specular = true;
    ++path.depth;
}

/// As a mirror does.
bool PacketWalk::reflect(SharedPath& path, const Vertex& vertex) {
    const Vec3 normal = mirror_normal(vertex);
    turn(path, vertex, normal, normalised(reflected(vertex.wo, normal)));
    return true;
}

bool PacketWalk::mirror(SharedPath& path, const Vertex& vertex, const Mirror& mirror) {
    tint(mirror.reflectance, vertex, path.lanes, path.beta);
    return reflect(path, vertex);
}

bool PacketWalk::metal(SharedPath& path, const Vertex& vertex, const Conductor& conductor) {
    LaneValues outside, reflectance;
    index_around(path.lanes, path.media, outside);
    const ConductorFresnel fresnel(conductor, path.lanes, outside);
    fresnel.at(std::min(1.0, dot(vertex.wo, mirror_normal(vertex))), reflectance);
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= reflectance[k];
    return reflect(path, vertex);
}

bool PacketWalk::thin(SharedPath& path, const Vertex& vertex, const ThinDielectric& pane) {
    LaneValues n, around, r;
    pane.index->eval_lanes(path.lanes.lambdas(), n.first(path.lanes.count));
    index_around(path.lanes, path.media, around);
    double mean = 0.0;
    for (int k = 0; k < path.lanes.count; ++k) {
        r[k] = pane_reflectance(dot(vertex.wo, vertex.shading), n[k] / around[k]);
        mean += r[k] / path.lanes.count;
    }
    const bool reflects = key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe) < mean;
    for (int k = 0; k < path.lanes.count; ++k)
        path.beta[k] *= reflects ? r[k] / mean : (1.0 - r[k]) / (1.0 - mean);
    if (!reflects) tint(pane.tint, vertex, path.lanes, path.beta);
    const Vec3 normal = mirror_normal(vertex);
    turn(path, vertex, normal, reflects ? normalised(reflected(vertex.wo, normal)) : -vertex.wo);
    return true;
}

bool PacketWalk::smooth(SharedPath& path, const Vertex& vertex, const Dielectric& glass, int id) {
    const Boundary boundary = boundary_at(path.media, vertex.front, id);
    if (boundary.none || !stops_shadows(vertex.shape)) {
        path.media = boundary.after;
        path.ray = vertex.leave(path.ray.direction);
        // Shadow rays do not know it: what lies behind is found by chance alone.
        path.last.specular = path.last.specular || stops_shadows(vertex.shape);
        path.hidden = path.hidden || stops_shadows(vertex.shape);
        return ++path.passed <= kMostPassed;
    }
    const int count = path.lanes.count;
    LaneValues eta;
    indices(path.lanes, boundary, eta);
    const bool spreads = count > 1 && dispersive(eta, count);
    if (spreads && !path.scattered && !path.split) {
        split_shared(path, vertex, glass, boundary, eta);
        return true;
    }
    const Vec3 normal = mirror_normal(vertex);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    LaneValues r;
    double mean = 0.0;
    for (int k = 0; k < count; ++k) {
        r[k] = spreads || k == 0 ? fresnel_dielectric(cos_i, eta[k]).unpolarised() : r[0];
        mean += r[k] / count;
    }
    if (!spreads) mean = r[0];
    const bool reflects = key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe) < mean;
    if (spreads)
        for (int k = 0; k < count; ++k)
            path.beta[k] *= reflects ? r[k] / mean : (1.0 - r[k]) / (1.0 - mean);
    if (reflects) {
        path.media = boundary.before;
        turn(path, vertex, normal, normalised(reflected(vertex.wo, normal)));
        return true;
    }
    tint(glass.tint, vertex, path.lanes, path.beta);
    if (spreads) {
        open_transmitted(path, vertex, path.beta, boundary, eta, normal);
        return false;
    }
    const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_i, eta[0])));
    path.media = boundary.after;
    turn(path, vertex, normal,
         normalised(normal * (cos_i / eta[0] - cos_t) - vertex.wo * (1.0 / eta[0])));
    return true;
}

/// Both ways at once: the refracted lanes are followed to their ends, the reflected path goes on.
void PacketWalk::split_shared(SharedPath& path, const Vertex& vertex, const Dielectric& glass,
                              const Boundary& boundary, const LaneValues& eta) {
    const Vec3 normal = mirror_normal(vertex);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    LaneValues refracted_beta = path.beta;
    for (int k = 0; k < path.lanes.count; ++k) {
        const double r = fresnel_dielectric(cos_i, eta[k]).unpolarised();
        refracted_beta[k] = path.beta[k] * (1.0 - r);
        path.beta[k] *= r;
    }
    tint(glass.tint, vertex, path.lanes, refracted_beta);
    open_transmitted(path, vertex, refracted_beta, boundary, eta, normal);
    path.media = boundary.before;
    path.split = true;
    path.branch = ++branches_;
    turn(path, vertex, normal, normalised(reflected(vertex.wo, normal)));
}

void PacketWalk::open_transmitted(const SharedPath& path, const Vertex& vertex,
                                  const LaneValues& beta, const Boundary& boundary,
                                  const LaneValues& eta, Vec3 normal) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = beta;
    open.depth = path.depth + 1;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.scattered = path.scattered;
    open.drops = path.drops;
    open.media.fill(boundary.after);
    open.note.v.fill(path.note);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    for (int k = 0; k < path.lanes.count; ++k) {
        const double cos2_t = cos2_transmitted(cos_i, eta[k]);
        if (!(cos2_t > 0.0) || beta[k] == 0.0) continue;
        const Vec3 d =
            normalised(normal * (cos_i / eta[k] - std::sqrt(cos2_t)) - vertex.wo * (1.0 / eta[k]));
        open.beta[k] *= shading_factor(vertex, normal, d);
        open.rays.set(k, vertex.leave(d));
        open.active |= 1u << k;
    }
    for (int k = 0; k < path.lanes.count; ++k)
        if (!(open.active >> k & 1u) && open.active)
            open.rays.set(k, open.rays.ray(std::countr_zero(open.active)));
    if (open.active) trace_open(open);
}

/// Rough glass is followed lane by lane from the first surface on.
bool PacketWalk::rough(SharedPath& path, const Hit& hit, const Dielectric& glass, int id) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = path.beta;
    open.depth = path.depth;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.active = (1u << path.lanes.count) - 1u;
    open.scattered = path.scattered;
    open.drops = path.drops;
    open.media.fill(path.media);
    open.hidden = path.hidden ? open.active : 0;
    open.note.v.fill(path.note);
    open.last.fill(path.last);
    for (int k = 0; k < path.lanes.count; ++k) open.rays.set(k, path.ray);
    HitLanes hits;
    hits.fill(hit);
    open_rough(open, open.active, hits, glass, id);
    ++open.depth;
    trace_open(open);
    return false;
}

}  // namespace dewbow::walk
