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

/// Called for each triangle that Embree believes to be hit: measures again in double precision, and
/// refuses the triangle that the ray starts on.
template <bool kOccluded>
void measure(const RTCFilterFunctionNArguments* args) {
    const auto& mesh = *static_cast<const WorldMesh*>(args->geometryUserPtr);
    Query& query = query_of(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] != -1) continue;
        const unsigned k = RTCRayN_id(args->ray, args->N, i);
        const int primitive = int(RTCHitN_primID(args->hit, args->N, i));
        const RayLanes& rays = *query.rays;
        const SurfaceFrom& from = rays.from[k];
        const bool same_shape = from.shape == mesh.shape;
        const FacetPlane& plane = mesh.planes[std::size_t(primitive)];
        const double height = plane.distance - dot(plane.normal, rays.origin(int(k)));
        const double slope = dot(plane.normal, rays.direction(int(k)));
        double t = height / slope;
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
            accept = accept && from.primitive != primitive;
            if (query.back)
                accept = accept && likely && distance <= kTouch * query.scale;
            else
                accept = accept && distance > (likely ? contact : kTouch * query.scale);
        } else if (query.back) {
            accept = false;
        }
        if (query.way_out) accept = accept && same_shape && slope > 0.0;
        if (kOccluded) accept = accept && !mesh.see_through;
        if (accept && mesh.opacity)
            accept = is_there(
                mesh.opacity->at(mesh.shape, primitive, double(RTCHitN_u(args->hit, args->N, i)),
                                 double(RTCHitN_v(args->hit, args->N, i))),
                {rays.origin(int(k)), rays.direction(int(k)), mesh.shape, primitive, slope < 0.0});
        if (!accept)
            args->valid[i] = 0;
        else if (!kOccluded)
            query.t[k] = t;
    }
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

}  // namespace

void measure_hit(const RTCFilterFunctionNArguments* args) { measure<false>(args); }
void measure_shadow(const RTCFilterFunctionNArguments* args) { measure<true>(args); }

void bound_analytic(const RTCBoundsFunctionArguments* args) {
    const auto& tree = *static_cast<const AcceleratorTree*>(args->geometryUserPtr);
    const Bounds& b = tree.analytic_bounds[args->primID];
    // Wider by the rounding to float, and by more, so that flat shapes have a volume.
    const double margin = 1e-6 * (tree.scale + length(b.high) + length(b.low));
    *args->bounds_o = {
        float(b.low.x - margin),  float(b.low.y - margin),  float(b.low.z - margin),  0.0f,
        float(b.high.x + margin), float(b.high.y + margin), float(b.high.z + margin), 0.0f};
}

void meet_analytic(const RTCIntersectFunctionNArguments* args) {
    meet<false>(*static_cast<const AcceleratorTree*>(args->geometryUserPtr), args->context,
                args->primID, args->N, args->valid, RTCRayHitN_RayN(args->rayhit, args->N),
                RTCRayHitN_HitN(args->rayhit, args->N), args->geomID);
}

void shadow_analytic(const RTCOccludedFunctionNArguments* args) {
    meet<true>(*static_cast<const AcceleratorTree*>(args->geometryUserPtr), args->context,
               args->primID, args->N, args->valid, args->ray, nullptr, args->geomID);
}

}  // namespace dewbow::embree_callbacks
