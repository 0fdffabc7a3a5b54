// SPDX-License-Identifier: Apache-2.0
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

#include "dewbow/render/accelerator_tree.h"

namespace dewbow::embree_callbacks {

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

Query& query_of(RTCIntersectContext* context) {
    return reinterpret_cast<QueryContext<RTCIntersectContext>*>(context)->query;
}

/// A triangle that Embree believes to be hit by lane k, in the world.
struct Proposal {
    int shape, primitive;
    FacetPlane plane;
    const Opacity* opacity;
    float u, v;
};

/// Measures the proposal again in double precision, and refuses the triangle that the ray starts
/// on. Sets `t`; returns whether it is nearer than all before, and there.
bool measure(const Query& query, unsigned k, const Proposal& triangle, double& t) {
    const RayLanes& rays = *query.rays;
    const SurfaceFrom& from = rays.from[k];
    const bool same_shape = from.shape == triangle.shape;
    const FacetPlane& plane = triangle.plane;
    const double height = plane.distance - dot(plane.normal, rays.origin(int(k)));
    const double slope = dot(plane.normal, rays.direction(int(k)));
    t = height / slope;
    const double contact = kSamePlane * query.scale;
    if (query.back || (!same_shape && slope < 0.0 && std::abs(height) <= contact))
        t = std::max(0.0, t);  // at its start already
    else if (!(t > 0.0))
        t = kUnlimited;
    else if (same_shape && from.inward && slope > 0.0)
        t = std::max(0.0, t - contact);  // out of the body before into what it stands on
    bool accept = t < query.t[k];
    if (same_shape) {
        // Inside, only the way out is near; outside, only the way in.
        const double distance = std::abs(height);
        const bool likely = (slope > 0.0) == from.inward;
        accept = accept && from.primitive != triangle.primitive;
        if (query.back)
            accept = accept && likely && distance <= kTouch * query.scale;
        else
            accept = accept && distance > (likely ? contact : kTouch * query.scale);
    } else if (query.back) {
        accept = false;
    }
    if (query.way_out) accept = accept && same_shape && slope > 0.0;
    if (!accept || !triangle.opacity) return accept;
    return is_there(triangle.opacity->at(triangle.shape, triangle.primitive, double(triangle.u),
                                         double(triangle.v)),
                    {rays.origin(int(k)), rays.direction(int(k)), triangle.shape,
                     triangle.primitive, slope < 0.0});
}

/// Embree's filter: `proposal_of(primitive)` knows the triangles of the geometry.
template <bool kOccluded, class ProposalOf>
void filter(const RTCFilterFunctionNArguments* args, const ProposalOf& proposal_of) {
    Query& query = query_of(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] != -1) continue;
        const unsigned k = RTCRayN_id(args->ray, args->N, i);
        Proposal triangle = proposal_of(int(RTCHitN_primID(args->hit, args->N, i)));
        triangle.u = RTCHitN_u(args->hit, args->N, i);
        triangle.v = RTCHitN_v(args->hit, args->N, i);
        double t = 0.0;
        if (!measure(query, k, triangle, t))
            args->valid[i] = 0;
        else if (!kOccluded)
            query.t[k] = t;
    }
}

template <bool kOccluded>
void filter_world(const RTCFilterFunctionNArguments* args) {
    const auto& mesh = *static_cast<const WorldMesh*>(args->geometryUserPtr);
    if (kOccluded && mesh.see_through) {
        std::fill_n(args->valid, args->N, 0);
        return;
    }
    filter<kOccluded>(args, [&](int primitive) -> Proposal {
        return {mesh.shape,   primitive, mesh.planes[std::size_t(primitive)],
                mesh.opacity, 0.0f,      0.0f};
    });
}

template <bool kOccluded>
void filter_instance(const RTCFilterFunctionNArguments* args) {
    const auto& tree = *static_cast<const AcceleratorTree*>(args->geometryUserPtr);
    const Instance& instance = *query_of(args->context).instance;
    filter<kOccluded>(args, [&](int primitive) -> Proposal {
        return {instance.shape,   primitive, tree.plane_of(instance, primitive),
                instance.opacity, 0.0f,      0.0f};
    });
}

template <bool kOccluded>
void meet(const AcceleratorTree& tree, RTCIntersectContext* context, unsigned primitive, unsigned n,
          const int* valid, RTCRayN* ray, RTCHitN* hit, unsigned geometry) {
    Query& query = query_of(context);
    if (query.back || query.way_out) return;
    const AnalyticShape& shape = tree.analytic[primitive];
    const int index = tree.analytic_shape[primitive];
    if (kOccluded && tree.see_through[std::size_t(index)]) return;
    for (unsigned i = 0; i < n; ++i) {
        if (valid[i] != -1) continue;
        const unsigned k = RTCRayN_id(ray, n, i);
        double t = 0.0;
        int face = 0;
        if (!tree.meet(shape, index, *query.rays, int(k), query.t[k], t, face)) continue;
        if (kOccluded) {
            RTCRayN_tfar(ray, n, i) = -std::numeric_limits<float>::infinity();
            continue;
        }
        query.t[k] = t;
        RTCRayN_tfar(ray, n, i) = float(t - query.start[k]);
        RTCHitN_geomID(hit, n, i) = geometry;
        RTCHitN_primID(hit, n, i) = primitive;
        RTCHitN_u(hit, n, i) = float(face);  // carried through Embree's record
        RTCHitN_instID(hit, n, i, 0) = context->instID[0];
    }
}

/// The ray of lane k in the frame of an instance, from its centre. It starts where it comes near:
/// single precision is that of the instance's own size.  @param limit  of Embree's ray.
/// @param start  set to where it starts along the true ray.
RTCRay ray_in_instance(const AcceleratorTree& tree, const Instance& instance, const Query& query,
                       unsigned k, double limit, double& start) {
    const Vec3 origin = query.rays->origin(int(k)) + query.shift;
    const Vec3 direction = query.rays->direction(int(k));
    const double to_centre = dot(tree.centre_of(instance) - origin, direction);
    start = std::max(query.start[k], to_centre - instance.radius);
    const Affine& object_from_world =
        tree.described.shapes[std::size_t(instance.shape)].world_from_object.inverse_affine();
    const Vec3 o = object_from_world.apply(origin + direction * start) -
                   tree.shared[std::size_t(instance.mesh)].bounds.centre();
    const Vec3 d = object_from_world.apply_linear(direction);
    RTCRay ray{};
    ray.org_x = float(o.x), ray.org_y = float(o.y), ray.org_z = float(o.z);
    ray.dir_x = float(d.x), ray.dir_y = float(d.y), ray.dir_z = float(d.z);
    ray.tfar = float(limit + query.start[k] - start);
    ray.mask = ~0u;
    ray.id = k;
    return ray;
}

template <bool kOccluded>
void meet_instance(const AcceleratorTree& tree, RTCIntersectContext* context, unsigned which,
                   unsigned n, const int* valid, RTCRayN* ray, RTCHitN* hit, unsigned geometry) {
    Query& query = query_of(context);
    const Instance& instance = tree.instances[which];
    if (kOccluded && tree.see_through[std::size_t(instance.shape)]) return;
    const SharedMesh& mesh = tree.shared[std::size_t(instance.mesh)];
    query.instance = &instance;
    for (unsigned i = 0; i < n; ++i) {
        if (valid[i] != -1) continue;
        const unsigned k = RTCRayN_id(ray, n, i);
        if ((query.back || query.way_out) && query.rays->from[k].shape != instance.shape) continue;
        double start = 0.0;
        RTCRayHit local;
        local.ray =
            ray_in_instance(tree, instance, query, k, double(RTCRayN_tfar(ray, n, i)), start);
        if (!(local.ray.tfar >= 0.0f)) continue;
        if (kOccluded) {
            rtcOccluded1(mesh.scene, context, &local.ray);
            if (local.ray.tfar < 0.0f) RTCRayN_tfar(ray, n, i) = local.ray.tfar;
            continue;
        }
        local.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        local.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(mesh.scene, context, &local);
        if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        RTCRayN_tfar(ray, n, i) = float(query.t[k] - query.start[k]);
        RTCHitN_geomID(hit, n, i) = geometry;
        RTCHitN_primID(hit, n, i) = local.hit.primID;
        RTCHitN_u(hit, n, i) = local.hit.u;
        RTCHitN_v(hit, n, i) = local.hit.v;
        RTCHitN_instID(hit, n, i, 0) = which;
    }
}

/// Wider by the rounding to float, and by more, so that flat shapes have a volume.
void store_bounds(const RTCBoundsFunctionArguments* args, const Bounds& b, double scale) {
    const double margin = 1e-6 * (scale + length(b.high) + length(b.low));
    *args->bounds_o = {
        float(b.low.x - margin),  float(b.low.y - margin),  float(b.low.z - margin),  0.0f,
        float(b.high.x + margin), float(b.high.y + margin), float(b.high.z + margin), 0.0f};
}

const AcceleratorTree& tree_of(void* user) { return *static_cast<const AcceleratorTree*>(user); }

}  // namespace

void measure_hit(const RTCFilterFunctionNArguments* args) { filter_world<false>(args); }
void measure_shadow(const RTCFilterFunctionNArguments* args) { filter_world<true>(args); }
void measure_instance_hit(const RTCFilterFunctionNArguments* args) { filter_instance<false>(args); }
void measure_instance_shadow(const RTCFilterFunctionNArguments* args) {
    filter_instance<true>(args);
}

void bound_analytic(const RTCBoundsFunctionArguments* args) {
    const AcceleratorTree& tree = tree_of(args->geometryUserPtr);
    const int shape = tree.analytic_shape[args->primID];
    store_bounds(args, bounds_of(tree.described.shapes[std::size_t(shape)]), tree.scale);
}

void meet_analytic(const RTCIntersectFunctionNArguments* args) {
    meet<false>(tree_of(args->geometryUserPtr), args->context, args->primID, args->N, args->valid,
                RTCRayHitN_RayN(args->rayhit, args->N), RTCRayHitN_HitN(args->rayhit, args->N),
                args->geomID);
}

void shadow_analytic(const RTCOccludedFunctionNArguments* args) {
    meet<true>(tree_of(args->geometryUserPtr), args->context, args->primID, args->N, args->valid,
               args->ray, nullptr, args->geomID);
}

void bound_instance(const RTCBoundsFunctionArguments* args) {
    const AcceleratorTree& tree = tree_of(args->geometryUserPtr);
    const Instance& instance = tree.instances[args->primID];
    const Shape& shape = tree.described.shapes[std::size_t(instance.shape)];
    store_bounds(args,
                 bounds_of_box(tree.shared[std::size_t(instance.mesh)].bounds,
                               shape.world_from_object.affine()),
                 tree.scale);
}

void meet_instance(const RTCIntersectFunctionNArguments* args) {
    meet_instance<false>(tree_of(args->geometryUserPtr), args->context, args->primID, args->N,
                         args->valid, RTCRayHitN_RayN(args->rayhit, args->N),
                         RTCRayHitN_HitN(args->rayhit, args->N), args->geomID);
}

void shadow_instance(const RTCOccludedFunctionNArguments* args) {
    meet_instance<true>(tree_of(args->geometryUserPtr), args->context, args->primID, args->N,
                        args->valid, args->ray, nullptr, args->geomID);
}

}  // namespace dewbow::embree_callbacks
