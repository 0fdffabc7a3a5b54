// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "dewbow/render/refract_lanes.h"
#include "dewbow/render/surface/ggx_lobe.h"
#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::walk {

namespace {

/// Of the lanes that meet something rough together, this many go on. Tuned on a room behind a pane,
/// a room lit through one and a wall behind a prism: two are worth 1.4, 1.6 and 1.4 of one (error ×
/// time).
constexpr int kLanesThatGoOn = 2;

}  // namespace

OpenPath PacketWalk::open_start(const RayLanes& rays, MediaStack media) const {
    OpenPath path;
    path.lanes = LaneSet::all(packet_);
    path.rays = rays;
    path.beta.v.fill(1.0);
    path.media.fill(media);
    path.active = (1u << rays.count) - 1u;
    path.note.v.fill(0.0);
    return path;
}

void PacketWalk::follow(const OpenPath& path) {
    trace_open(path);
    finish_pending();
}

void PacketWalk::trace_open(OpenPath path) {
    HitLanes hits;
    while (path.active) {
        prepared_.accelerator.intersect(path.rays, path.active, hits);
        for (LaneMask rest = path.active; rest; rest &= rest - 1)
            open_arrive(path, std::countr_zero(rest), hits);
        if (path.depth >= settings_.max_depth) return;
        std::array<int, kMaxLanes> materials;
        LaneMask from_outside = 0;
        const std::uint32_t at = vertex_key(path.depth, path.branch);
        for (LaneMask rest = path.active; rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const Hit& hit = hits[std::size_t(k)];
            materials[std::size_t(k)] = material_at(path.rays.ray(k), hit, at);
            from_outside |= LaneMask(dot(path.rays.direction(k), hit.normal) < 0.0) << k;
        }
        // Lanes that meet the same surface in the same way go together.
        for (LaneMask rest = path.active; rest;) {
            const auto first = std::size_t(std::countr_zero(rest));
            const bool front = from_outside >> first & 1u;
            LaneMask group = 0;
            for (LaneMask m = rest & (front ? from_outside : ~from_outside); m; m &= m - 1) {
                const auto i = std::size_t(std::countr_zero(m));
                const bool same = hits[i].shape == hits[first].shape &&
                                  path.media[i] == path.media[first] &&
                                  materials[i] == materials[first];
                group |= LaneMask(same) << i;
            }
            rest &= ~group;
            open_group(path, group, hits, materials[first]);
        }
        ++path.depth;
        if (path.active && !roulette(path.beta, path.lanes.count, path.active, path.depth,
                                     vertex_key(path.depth, path.branch)))
            return;
    }
}

/// Lane k at the end of its ray: what it lost on the way, and the light that it finds there.
void PacketWalk::open_arrive(OpenPath& path, int k, const HitLanes& hits) {
    const auto i = std::size_t(k);
    const Hit& hit = hits[i];
    if (sees_fog(path.media[i], path.scattered)) {
        SharedPath lane = lane_of(path, k);
        on_sight(lane, hit);
        path.beta[k] = lane.beta[0];
    }
    if (scatters(path.media[i], path.depth)) on_flight(lane_of(path, k), hit);
    if (settings_.rain.multiple() && !open_in_rain(path, k, hit)) return;
    if (in_weather(path.media[i])) {
        SharedPath lane = lane_of(path, k);
        dim(flight(lane, hit), lane.lanes, lane.beta);
        path.beta[k] = lane.beta[0];
    }
    if (!hit) {
        on_leaving(lane_of(path, k));
        path.active &= ~(1u << k);
        return;
    }
    if (const auto* sigma = packet_media().extinction(path.media[i].interior()))
        path.beta[k] *= std::exp(-(*sigma)[std::size_t(path.lanes.id[i])] * hit.t);
    if (prepared_.lights.emits(hit, path.rays.direction(k))) on_lamp(lane_of(path, k), hit);
}

void PacketWalk::open_group(OpenPath& path, LaneMask group, const HitLanes& hits, int material_id) {
    const Material& material = this->material(material_id);
    const int medium = prepared_.media.interior_of(material_id);
    if (const auto* glass = std::get_if<Dielectric>(&material.surface)) {
        if (is_rough(*glass))
            open_rough(path, group, hits, *glass, medium);
        else
            open_smooth(path, group, hits, *glass, medium);
    } else if (ScatteringSurface::holds(material)) {
        collapse(path, group, hits, material);
    } else if (std::holds_alternative<Black>(material.surface)) {
        path.active &= ~group;
    } else {
        open_one_by_one(path, group, hits, material);
    }
}

/// Takes a lane straight through a surface that is none. Shadow rays mostly know nothing of that:
/// what lies behind such a surface is found by chance alone.
void PacketWalk::pass(OpenPath& path, int k, const Hit& hit, const Boundary& boundary) {
    const auto i = std::size_t(k);
    path.media[i] = boundary.after;
    path.rays.set(k, vertex_at(path.rays.ray(k), hit).leave(path.rays.direction(k)));
    path.last[i].specular = path.last[i].specular || stops_shadows(hit.shape);
    path.hidden |= LaneMask(stops_shadows(hit.shape)) << k;
}

void PacketWalk::open_smooth(OpenPath& path, LaneMask group, const HitLanes& hits,
                             const Dielectric& glass, int id) {
    const auto first = std::size_t(std::countr_zero(group));
    const bool front = dot(path.rays.direction(int(first)), hits[first].normal) < 0.0;
    const Boundary boundary = boundary_at(path.media[first], front, id);
    const int count = path.lanes.count;
    if (boundary.none || !stops_shadows(hits[first].shape)) {
        for (int k = 0; k < count; ++k)
            if (group >> k & 1u) pass(path, k, hits[std::size_t(k)], boundary);
        return;
    }
    BoundaryLanes lanes;
    indices(path.lanes, boundary, lanes.eta);
    // Lanes outside the group are computed along and not used.
    for (LaneValues* n : {&lanes.nx, &lanes.ny, &lanes.nz}) n->v.fill(0.0);
    std::array<Vec3, kMaxLanes> position;
    const bool flat = has_true_normals(hits[first].shape);
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        const auto i = std::size_t(k);
        position[i] = path.rays.origin(k) + path.rays.direction(k) * hits[i].t;
        const Vec3 n = !flat   ? mirror_normal(vertex_at(path.rays.ray(k), hits[i]))
                       : front ? hits[i].normal
                               : -hits[i].normal;
        lanes.nx.v[i] = n.x, lanes.ny.v[i] = n.y, lanes.nz.v[i] = n.z;
    }
    const double u = choice_of_lanes(path);
    refract_or_reflect_lanes(count, u, path.rays, lanes);
    LaneMask reflected = 0;
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        reflected |= LaneMask(lanes.reflected[k] != 0.0) << k;
    }
    tint_open(glass.tint, path, group & ~reflected, path.rays, hits);
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        const auto i = std::size_t(k);
        const bool reflects = reflected >> k & 1u;
        const Vec3 direction{lanes.dx.v[i], lanes.dy.v[i], lanes.dz.v[i]};
        if (!flat && start_ == Start::lamp)
            path.beta[k] *=
                shading_factor(vertex_at(path.rays.ray(k), hits[i]),
                               {lanes.nx.v[i], lanes.ny.v[i], lanes.nz.v[i]}, direction);
        path.media[i] = reflects ? boundary.before : boundary.after;
        path.rays.set(
            k, {position[i], direction, {hits[i].shape, hits[i].primitive, front != reflects}});
        path.last[i].specular = true;
    }
}

/// Each lane at a rough boundary, by one microfacet for all of them.
void PacketWalk::open_rough(OpenPath& path, LaneMask group, const HitLanes& hits,
                            const Dielectric& glass, int id) {
    const auto first = std::size_t(std::countr_zero(group));
    const bool front = dot(path.rays.direction(int(first)), hits[first].normal) < 0.0;
    const Boundary boundary = boundary_at(path.media[first], front, id);
    const RayLanes arriving = path.rays;
    LaneValues eta;
    indices(path.lanes, boundary, eta);
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const double u = key_.one(at, Purpose::bsdf_lobe);
    const std::array<double, 2> u_facet = key_.two(at, Purpose::bsdf_direction);
    LaneMask refracted = 0;
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const auto i = std::size_t(k);
        const Vertex vertex = vertex_at(path.rays.ray(k), hits[i]);
        if (boundary.none || std::abs(eta[k] - 1.0) <= kSameIndex) {
            pass(path, k, hits[i], boundary);
            refracted |= LaneMask(!boundary.none) << k;
            continue;
        }
        SharedPath lane = lane_of(path, k);
        const double alpha = alpha_of_roughness(inputs_at(vertex).number(glass.roughness));
        const LocalFrame frame(vertex.shading);
        const Vec3 wo = frame.to_local(vertex.wo);
        path.active &= ~(1u << k);
        if (wo.z <= 0.0) continue;
        const RoughDielectric surface(wo, alpha, eta[k]);
        const RoughGlass met{hits[i], vertex, frame, glass, boundary, alpha, eta[k], surface};
        on_rough_glass(lane, met);
        const std::optional<Vec3> wi = surface.sample(u, u_facet);
        if (!wi) continue;
        const bool reflects = wi->z > 0.0;
        const Vec3 direction = frame.to_world(*wi);
        if ((dot(direction, vertex.geometric) > 0.0) != reflects) continue;
        const RoughDielectric::Value value = surface.eval(*wi);
        if (!(value.pdf > 0.0)) continue;
        path.beta[k] *= value.f_cos / value.pdf * shading_factor(vertex, vertex.shading, direction);
        path.media[i] = reflects ? boundary.before : boundary.after;
        lane.ray = vertex.leave(direction);
        on_rough_turn(lane, met);
        path.note[k] = lane.note;
        path.rays.set(k, lane.ray);
        path.last[i] = {false, value.pdf, vertex.receiver(true), true};
        path.active |= 1u << k;
        refracted |= LaneMask(!reflects) << k;
    }
    tint_open(glass.tint, path, refracted, arriving, hits);
}

/// What is smooth and not glass: rare among opened lanes.
void PacketWalk::open_one_by_one(OpenPath& path, LaneMask group, const HitLanes& hits,
                                 const Material& material) {
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const auto i = std::size_t(k);
        SharedPath lane = lane_of(path, k);
        const Vertex vertex = vertex_at(lane.ray, hits[i]);
        if (const auto* m = std::get_if<Mirror>(&material.surface))
            mirror(lane, vertex, *m);
        else if (const auto* c = std::get_if<Conductor>(&material.surface))
            metal(lane, vertex, *c);
        else
            thin(lane, vertex, std::get<ThinDielectric>(material.surface));
        path.rays.set(k, lane.ray);
        path.beta[k] = lane.beta[0];
        path.media[i] = lane.media;
        path.last[i].specular = true;
    }
}

/// Lanes that meet something rough together: each takes direct light, a few go on.
void PacketWalk::collapse(OpenPath& path, LaneMask group, const HitLanes& hits,
                          const Material& material) {
    double total = 0.0;
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const SharedPath lane = lane_of(path, k);
        const Vertex vertex = vertex_at(lane.ray, hits[std::size_t(k)]);
        const LocalFrame frame(vertex.shading);
        on_scatterer(lane, {hits[std::size_t(k)], vertex, frame, material,
                            surface_at(lane.lanes, lane.media, vertex, frame, material)});
        total += path.beta[k];
    }
    path.active &= ~group;
    if (!(total > 0.0)) return;
    const int count = std::min(kLanesThatGoOn, std::popcount(group));
    const double u = key_.one(vertex_key(path.depth, path.branch), Purpose::lane_choice);
    for (int i = 0; i < count; ++i) {
        const int chosen = lane_at(path, group, (u + i) / count * total);
        SharedPath lane = lane_of(path, chosen);
        lane.branch = ++branches_;
        const Vertex vertex = vertex_at(lane.ray, hits[std::size_t(chosen)]);
        lane.beta[0] = total / count;  // β over the expected number of times that it is chosen
        if (scatter(lane, hits[std::size_t(chosen)], vertex, material, false) &&
            roulette(lane.beta, 1, 1u, lane.depth, vertex_key(lane.depth, lane.branch)))
            memory_.pending.push_back(lane);
    }
}

/// The lane of `group` in which the running sum of throughputs passes `target`.
int PacketWalk::lane_at(const OpenPath& path, LaneMask group, double target) {
    int chosen = std::countr_zero(group);
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        if (path.beta[k] == 0.0) continue;
        chosen = k;
        target -= path.beta[k];
        if (target < 0.0) break;
    }
    return chosen;
}

}  // namespace dewbow::walk
