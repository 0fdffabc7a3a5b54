// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/path/tracer.h"

namespace dewbow::path_tracing {

namespace {

/// Boundaries that are none (between equal media, inside overlaps) passed at one go before a path
/// is given up: more than any real scene nests.
constexpr int kMostPassed = 64;

/// Surfaces are looked at from above, if only by rounding.
constexpr double kLeastCosineSeen = 1e-12;

}  // namespace

PixelSample Tracer::run(const Ray& ray, MediaStack media) {
    result_.wavelengths = packet_;
    SharedPath path;
    path.ray = ray;
    path.lanes = LaneSet::all(packet_);
    path.beta.v.fill(1.0);
    path.media = media;
    pending_.clear();
    trace(path);
    finish_pending();
    return result_;
}

PixelSample Tracer::run_open(const Ray& first, const RayLanes& rays, MediaStack media) {
    result_.wavelengths = packet_;
    const Hit hit = prepared_.accelerator.intersect(first);
    if (hit && settings_.max_depth > 0)
        see_first(prepared_, vertex_at(first, hit), material_at(first, hit, vertex_key(0, 0)),
                  result_);
    OpenPath open;
    open.lanes = LaneSet::all(packet_);
    open.rays = rays;
    open.beta.v.fill(1.0);
    open.media.fill(media);
    open.active = (1u << rays.count) - 1u;
    open.from_specular.fill(true);
    open.last_pdf.v.fill(0.0);
    pending_.clear();
    trace_open(open);
    finish_pending();
    return result_;
}

void Tracer::finish_pending() {
    while (!pending_.empty()) {
        const SharedPath next = pending_.back();
        pending_.pop_back();
        trace(next);
    }
}

void Tracer::trace(SharedPath path) {
    for (;;) {
        const Hit hit = prepared_.accelerator.intersect(path.ray);
        if (hit) absorb(path.lanes, path.beta, path.media, hit.t);
        if (!hit) {
            add_infinite(path.lanes, path.beta, path.ray.direction, path.from_specular,
                         path.last_pdf, path.last_receiver, path.media);
            return;
        }
        if (prepared_.lights.emits(hit, path.ray.direction))
            add_emission(path.lanes, path.beta, path.ray, hit, path.from_specular, path.last_pdf,
                         path.last_receiver, path.media);
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
bool Tracer::interact(SharedPath& path, const Hit& hit) {
    const Vertex vertex = vertex_at(path.ray, hit);
    const std::uint32_t at =
        vertex_key(path.depth, path.branch) + std::uint32_t(path.passed) * 0x85ebca6bu;
    const int id = material_at(path.ray, hit, at);
    const Material& material = this->material(id);
    if (!result_.hit && path.depth == 0 && path.branch == 0)
        see_first(prepared_, vertex, id, result_);
    if (const auto* glass = std::get_if<Dielectric>(&material.surface))
        return is_rough(*glass) ? rough(path, hit, *glass, prepared_.media.interior_of(id))
                                : smooth(path, vertex, *glass, prepared_.media.interior_of(id));
    if (ScatteringSurface::holds(material)) return scatter(path, vertex, material, true);
    if (const auto* m = std::get_if<Mirror>(&material.surface)) return mirror(path, vertex, *m);
    if (const auto* c = std::get_if<Conductor>(&material.surface)) return metal(path, vertex, *c);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return thin(path, vertex, *pane);
    return false;
}

ScatteringSurface Tracer::surface_at(const SharedPath& path, const Vertex& vertex,
                                     const LocalFrame& frame, const Material& material) {
    LaneValues outside;
    index_around(path.lanes, path.media, outside);
    Vec3 wo = frame.to_local(vertex.wo);
    wo.z = std::max(wo.z, kLeastCosineSeen);
    return {material, {inputs_at(vertex), path.lanes, outside, wo}};
}

bool Tracer::scatter(SharedPath& path, const Vertex& vertex, const Material& material,
                     bool take_direct) {
    const LocalFrame frame(vertex.shading);
    const ScatteringSurface surface = surface_at(path, vertex, frame, material);
    if (take_direct) direct_scattered(path, vertex, frame, surface, material);
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const std::optional<Vec3> wi =
        surface.sample(key_.one(at, Purpose::bsdf_lobe), key_.two(at, Purpose::bsdf_direction));
    if (!wi) return false;
    LaneValues f;
    const double pdf = surface.eval(*wi, f);
    const Vec3 direction = frame.to_world(*wi);
    const bool above = dot(direction, vertex.geometric) > 0.0;
    if (!(pdf > 0.0) || above != (wi->z > 0.0)) return false;
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= f[k] / pdf;
    path.ray = vertex.leave(direction);
    path.from_specular = false;
    path.scattered = true;
    path.last_pdf = pdf;
    path.last_receiver = vertex.receiver(ScatteringSurface::transmits(material));
    ++path.depth;
    return true;
}

/// As a mirror does.
bool Tracer::reflect(SharedPath& path, const Vertex& vertex) {
    path.ray = vertex.leave(normalised(reflected(vertex.wo, mirror_normal(vertex))));
    path.from_specular = true;
    ++path.depth;
    return true;
}

bool Tracer::mirror(SharedPath& path, const Vertex& vertex, const Mirror& mirror) {
    tint(mirror.reflectance, vertex, path.lanes, path.beta);
    return reflect(path, vertex);
}

bool Tracer::metal(SharedPath& path, const Vertex& vertex, const Conductor& conductor) {
    LaneValues outside, reflectance;
    index_around(path.lanes, path.media, outside);
    const ConductorFresnel fresnel(conductor, path.lanes, outside);
    fresnel.at(std::min(1.0, dot(vertex.wo, mirror_normal(vertex))), reflectance);
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= reflectance[k];
    return reflect(path, vertex);
}

bool Tracer::thin(SharedPath& path, const Vertex& vertex, const ThinDielectric& pane) {
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
    const Vec3 direction =
        reflects ? normalised(reflected(vertex.wo, mirror_normal(vertex))) : -vertex.wo;
    path.ray = vertex.leave(direction);
    path.from_specular = true;
    ++path.depth;
    return true;
}

bool Tracer::smooth(SharedPath& path, const Vertex& vertex, const Dielectric& glass, int id) {
    const Boundary boundary = boundary_at(path.media, vertex.front, id);
    if (boundary.none || !stops_shadows(vertex.shape)) {
        path.media = boundary.after;
        path.ray = vertex.leave(path.ray.direction);
        // Shadow rays do not know it: what lies behind is found by chance alone.
        path.from_specular = path.from_specular || stops_shadows(vertex.shape);
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
    path.from_specular = true;
    if (reflects) {
        path.media = boundary.before;
        path.ray = vertex.leave(normalised(reflected(vertex.wo, normal)));
        ++path.depth;
        return true;
    }
    tint(glass.tint, vertex, path.lanes, path.beta);
    if (spreads) {
        open_transmitted(path, vertex, path.beta, boundary, eta, normal);
        return false;
    }
    const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_i, eta[0])));
    path.media = boundary.after;
    path.ray =
        vertex.leave(normalised(normal * (cos_i / eta[0] - cos_t) - vertex.wo * (1.0 / eta[0])));
    ++path.depth;
    return true;
}

/// Both ways at once: the refracted lanes are followed to their ends, the reflected path goes on.
void Tracer::split_shared(SharedPath& path, const Vertex& vertex, const Dielectric& glass,
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
    path.ray = vertex.leave(normalised(reflected(vertex.wo, normal)));
    path.split = true;
    path.from_specular = true;
    path.branch = ++branches_;
    ++path.depth;
}

void Tracer::open_transmitted(const SharedPath& path, const Vertex& vertex, const LaneValues& beta,
                              const Boundary& boundary, const LaneValues& eta, Vec3 normal) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = beta;
    open.depth = path.depth + 1;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.last_pdf.v.fill(0.0);
    open.from_specular.fill(true);
    open.media.fill(boundary.after);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    for (int k = 0; k < path.lanes.count; ++k) {
        const double cos2_t = cos2_transmitted(cos_i, eta[k]);
        if (!(cos2_t > 0.0) || beta[k] == 0.0) continue;
        const Vec3 d =
            normalised(normal * (cos_i / eta[k] - std::sqrt(cos2_t)) - vertex.wo * (1.0 / eta[k]));
        open.rays.set(k, vertex.leave(d));
        open.active |= 1u << k;
    }
    for (int k = 0; k < path.lanes.count; ++k)
        if (!(open.active >> k & 1u) && open.active)
            open.rays.set(k, open.rays.ray(std::countr_zero(open.active)));
    if (open.active) trace_open(open);
}

/// Rough glass is followed lane by lane from the first surface on.
bool Tracer::rough(SharedPath& path, const Hit& hit, const Dielectric& glass, int id) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = path.beta;
    open.depth = path.depth;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.active = (1u << path.lanes.count) - 1u;
    open.media.fill(path.media);
    open.from_specular.fill(path.from_specular);
    open.last_pdf.v.fill(path.last_pdf);
    open.last_receiver.fill(path.last_receiver);
    for (int k = 0; k < path.lanes.count; ++k) open.rays.set(k, path.ray);
    HitLanes hits;
    hits.fill(hit);
    open_rough(open, open.active, hits, glass, id);
    ++open.depth;
    trace_open(open);
    return false;
}

}  // namespace dewbow::path_tracing
