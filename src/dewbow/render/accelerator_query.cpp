// SPDX-License-Identifier: Apache-2.0
#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "dewbow/render/accelerator_tree.h"

namespace dewbow {

namespace {

/// Embree's rays start this far behind the surface that they leave, relative to the size of the
/// coordinates, so that single precision does not put them beyond what touches it. The filter
/// refuses what is met too early.
constexpr double kHeadStart = 1e-5;
/// How far behind its start a ray is looked at for a triangle within kTouch, in the same measure:
/// those that it meets at a sine above kTouch / kLookBack are found.
constexpr double kLookBack = 1e-4;
/// Fewer rays than this go through the tree one by one.
constexpr int kLeastForPacket = 4;
/// Things nearer to a light than this share of the distance do not hide it: rounding of the light's
/// point.
constexpr double kBeforeLight = 1.0 - 1e-9;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

using Context = QueryContext<RTCIntersectContext>;

template <class RayHit>
void load_rays(const Query& query, int n, RayHit& packet) {
    const RayLanes& rays = *query.rays;
    for (std::size_t k = 0; k < std::size_t(n); ++k) {
        packet.ray.org_x[k] = float(rays.ox[k] + query.start[k] * rays.dx[k]);
        packet.ray.org_y[k] = float(rays.oy[k] + query.start[k] * rays.dy[k]);
        packet.ray.org_z[k] = float(rays.oz[k] + query.start[k] * rays.dz[k]);
        packet.ray.dir_x[k] = float(rays.dx[k]);
        packet.ray.dir_y[k] = float(rays.dy[k]);
        packet.ray.dir_z[k] = float(rays.dz[k]);
        packet.ray.tnear[k] = 0.0f;
        packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
        packet.ray.time[k] = 0.0f;
        packet.ray.mask[k] = ~0u;
        packet.ray.id[k] = unsigned(k);
        packet.ray.flags[k] = 0;
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
}

/// In place: a copy would have to wait for what was just written.  @param limit  along the true
/// ray.
void load_ray(const Query& query, int k, double limit, RTCRay& ray) {
    const double start = query.start[std::size_t(k)];
    const Vec3 d = query.rays->direction(k), origin = query.rays->origin(k) + d * start;
    ray.org_x = float(origin.x), ray.org_y = float(origin.y), ray.org_z = float(origin.z);
    ray.dir_x = float(d.x), ray.dir_y = float(d.y), ray.dir_z = float(d.z);
    ray.tnear = 0.0f;
    ray.tfar = float(limit - start);
    ray.time = 0.0f;
    ray.mask = ~0u;
    ray.id = unsigned(k);
    ray.flags = 0;
}

void load_ray_hit(const Query& query, int k, double limit, RTCRayHit& ray_hit) {
    load_ray(query, k, limit, ray_hit.ray);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

Found found_by(const RTCHit& hit) { return {hit.geomID, hit.primID, hit.instID[0], hit.u, hit.v}; }

Context make_context(const RayLanes& rays, double limit, double scale, bool coherent) {
    Context context;
    rtcInitIntersectContext(&context.embree);
    context.embree.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    Query& query = context.query;
    query.rays = &rays;
    query.t.fill(limit);
    query.start.fill(0.0);
    query.scale = scale;
    return context;
}

}  // namespace

bool AcceleratorTree::meet(const AnalyticShape& shape, int index, const RayLanes& rays, int k,
                           double limit, double& t, int& face) const {
    const SurfaceFrom& from = rays.from[std::size_t(k)];
    const bool from_here = from.shape == index;
    const Vec3 origin = rays.origin(k), direction = rays.direction(k);
    if (!shape.intersect(origin, direction, from_here, from.inward, limit, t, face)) return false;
    if (!opacity_of(index)) return true;
    const auto there = [&](Vec3 point, bool inward) {
        const SurfaceChart at = shape.chart(point, face);
        return is_there(opacity->at(index, face, at.u, at.v),
                        {origin, direction, index, face, inward});
    };
    const Vec3 near = origin + direction * t;
    const bool inward = dot(shape.normal(near, face), direction) < 0.0;
    if (there(near, inward)) return true;
    // In by a hole. The way out is another place.
    double rest = 0.0;
    if (!inward || !shape.intersect(near, direction, true, true, limit - t, rest, face))
        return false;
    t += rest;
    return there(origin + direction * t, false);
}

void AcceleratorTree::meet_planes(const RayLanes& rays, int k, Hit& hit) const {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        double t = 0.0;
        int face = 0;
        if (!meet(planes[i], plane_shape[i], rays, k, hit.t, t, face)) continue;
        hit.t = t;
        hit.shape = plane_shape[i];
        hit.primitive = 0;
        hit.normal = planes[i].normal({}, 0);
    }
}

/// The hit of what Embree found; `hit.t` is set.
void AcceleratorTree::finish_lane(const RayLanes& rays, int k, const Found& found, Hit& hit) const {
    hit.primitive = int(found.primitive);
    hit.u = double(found.u);
    hit.v = double(found.v);
    if (found.geometry == RTC_INVALID_GEOMETRY_ID) {
        hit.shape = -1;
        hit.t = kUnlimited;
    } else if (found.geometry < meshes.size()) {
        const WorldMesh& mesh = meshes[found.geometry];
        hit.shape = mesh.shape;
        hit.normal = mesh.planes[found.primitive].normal;
    } else if (found.geometry == instance_geometry()) {
        const Instance& instance = instances[found.instance];
        hit.shape = instance.shape;
        hit.normal = plane_of(instance, hit.primitive).normal;
    } else {
        hit.shape = analytic_shape[found.primitive];
        hit.primitive = int(found.u);
        hit.normal = analytic[found.primitive].normal(rays.origin(k) + rays.direction(k) * hit.t,
                                                      hit.primitive);
    }
    if (!planes.empty()) meet_planes(rays, k, hit);
}

/// Lanes that are inside a body with nothing in it: their hits, without the tree. Returns the
/// others.
LaneMask AcceleratorTree::leave_undisturbed(const RayLanes& rays, LaneMask mask,
                                            std::span<Hit> hits) const {
    LaneMask others = 0;
    for (LaneMask rest = mask; rest;) {
        const int first = std::countr_zero(rest);
        const SurfaceFrom& from = rays.from[std::size_t(first)];
        LaneMask group = 0;
        for (LaneMask m = rest; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            const SurfaceFrom& other = rays.from[std::size_t(k)];
            group |= LaneMask(other.shape == from.shape && other.inward == from.inward) << k;
        }
        rest &= ~group;
        if (from.shape < 0 || !from.inward || !undisturbed[std::size_t(from.shape)]) {
            others |= group;
            continue;
        }
        for (LaneMask m = group; m; m &= m - 1)
            hits[std::size_t(std::countr_zero(m))].shape = from.shape;
        if (const ConvexSolid* solid = solid_of(from.shape)) {
            solid->leave(rays, group, hits);
            continue;
        }
        const AnalyticShape& shape = analytic_of(from.shape);
        for (LaneMask m = group; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            Hit& hit = hits[std::size_t(k)];
            shape.intersect(rays.origin(k), rays.direction(k), true, true, kUnlimited, hit.t,
                            hit.primitive);
            hit.normal = shape.normal(rays.origin(k) + rays.direction(k) * hit.t, hit.primitive);
        }
    }
    return others;
}

/// Where along a ray Embree is to begin.
double AcceleratorTree::start_of(const Ray& ray) const {
    const double at_edge = dot(centre - ray.origin, ray.direction) - radius;
    if (at_edge > 0.0) return at_edge;
    return ray.from.shape >= 0 ? -kHeadStart * scale : 0.0;
}

/// A ray that went inward from a mesh has not met the way out, but something else or nothing. Where
/// it started near an edge, Embree's ray may run outside, beside that edge; then the neighbouring
/// triangle is the way out, at once. So Embree gets a ray that starts a little further back and
/// inward. (No body may be left unseen: its inside would be taken for the world.)
void AcceleratorTree::look_back(const RayLanes& rays, int k, Hit& hit) const {
    const SurfaceFrom& from = rays.from[std::size_t(k)];
    const Vec3 inward = plane_of(from.shape, from.primitive).normal * (-kTouch * scale);
    Context context = make_context(rays, hit.t, scale, false);
    context.query.back = true;
    context.query.shift = inward;
    context.query.start[std::size_t(k)] = -kLookBack * scale;
    RTCRayHit single;
    load_ray_hit(context.query, k, kLookBack * scale, single);
    single.ray.org_x += float(inward.x);
    single.ray.org_y += float(inward.y);
    single.ray.org_z += float(inward.z);
    rtcIntersect1(scene, &context.embree, &single);
    if (single.hit.geomID == RTC_INVALID_GEOMETRY_ID && hit) {
        // What was hit may be what the body stands on, met at the very distance of the way out.
        context = make_context(rays, hit.t + kSamePlane * scale, scale, false);
        context.query.way_out = true;
        load_ray_hit(context.query, k, hit.t + kHeadStart * scale, single);
        rtcIntersect1(scene, &context.embree, &single);
    }
    if (single.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    hit.t = context.query.t[std::size_t(k)];
    finish_lane(rays, k, found_by(single.hit), hit);
}

void AcceleratorTree::intersect(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const {
    mask = leave_undisturbed(rays, mask, hits);
    if (!mask) return;
    Context context = make_context(rays, kUnlimited, scale, rays.count > 1);
    for (LaneMask m = mask; m; m &= m - 1) {
        const int k = std::countr_zero(m);
        context.query.start[std::size_t(k)] = start_of(rays.ray(k));
    }
    const auto finish = [&](int k, const Found& found) {
        Hit& hit = hits[std::size_t(k)];
        hit.t = context.query.t[std::size_t(k)];
        finish_lane(rays, k, found, hit);
        const SurfaceFrom& from = rays.from[std::size_t(k)];
        if (from.inward && is_mesh(from.shape) &&
            !(hit.shape == from.shape && dot(hit.normal, rays.direction(k)) > 0.0))
            look_back(rays, k, hit);
    };
    if (std::popcount(mask) < kLeastForPacket) {
        for (LaneMask m = mask; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            RTCRayHit single;
            load_ray_hit(context.query, k, kUnlimited, single);
            rtcIntersect1(scene, &context.embree, &single);
            finish(k, found_by(single.hit));
        }
        return;
    }
    alignas(64) std::array<int, kMaxLanes> valid;
    for (int k = 0; k < kMaxLanes; ++k) valid[std::size_t(k)] = (mask >> k & 1u) ? -1 : 0;
    const auto trace_packet = [&](auto& packet, auto&& trace, int width) {
        load_rays(context.query, width, packet);
        trace(valid.data(), scene, &context.embree, &packet);
        for (LaneMask m = mask; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            finish(k, {packet.hit.geomID[k], packet.hit.primID[k], packet.hit.instID[0][k],
                       packet.hit.u[k], packet.hit.v[k]});
        }
    };
    if (rays.count <= 4) {
        RTCRayHit4 packet;
        trace_packet(packet, rtcIntersect4, 4);
    } else if (rays.count <= 8) {
        RTCRayHit8 packet;
        trace_packet(packet, rtcIntersect8, 8);
    } else {
        RTCRayHit16 packet;
        trace_packet(packet, rtcIntersect16, 16);
    }
}

bool AcceleratorTree::occluded(const Ray& ray, double distance) const {
    RayLanes rays;
    rays.count = 1;
    rays.set(0, ray);
    const double limit = distance * kBeforeLight;
    const SurfaceFrom& from = ray.from;
    const bool in_body = from.inward && !see_through[std::size_t(from.shape)];
    if (in_body && undisturbed[std::size_t(from.shape)]) {
        Hit hit;
        leave_undisturbed(rays, 1u, std::span(&hit, 1));
        return hit.t < limit;
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        double t = 0.0;
        int face = 0;
        const int shape = plane_shape[i];
        if (!see_through[std::size_t(shape)] && meet(planes[i], shape, rays, 0, limit, t, face))
            return true;
    }
    Context context = make_context(rays, limit, scale, false);
    context.query.start[0] = start_of(ray);
    if (context.query.start[0] >= limit) return false;
    RTCRay single;
    load_ray(context.query, 0, limit, single);
    rtcOccluded1(scene, &context.embree, &single);
    if (single.tfar < 0.0f) return true;
    if (!in_body || !is_mesh(from.shape)) return false;
    // Out of a mesh without meeting it? Only if the slower query agrees, which looks beside edges
    // too.
    Hit hit;
    intersect(rays, 1u, std::span(&hit, 1));
    return hit.shape == from.shape && hit.t < limit;
}

}  // namespace dewbow
