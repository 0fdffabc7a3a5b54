// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/accelerator.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "dewbow/base/check.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/analytic_shape.h"
#include "dewbow/render/convex_solid.h"
#include "dewbow/render/undisturbed.h"

namespace dewbow {

namespace {

/// A ray whose origin is nearer to a triangle's plane than this times the size of the coordinates
/// starts on it: it left the other triangle of a flat facet, or a body that stands on it. Some
/// hundred times the rounding of that distance.
constexpr double kSamePlane = 1e-13;
/// Embree's rays start this far behind the surface that they leave, in the same measure, so that
/// single precision does not put them beyond what touches it. The filter refuses what is met too
/// early.
constexpr double kHeadStart = 1e-5;
/// Embree's single precision may put the start of a ray on the wrong side of a triangle that is
/// nearer than this times the size of the coordinates: 16 roundings.
constexpr double kTouch = 1e-6;
/// How far behind its start a ray is looked at for such a triangle, in the same measure: those that
/// it meets at a sine above kTouch / kLookBack are found.
constexpr double kLookBack = 1e-4;
/// Fewer rays than this go through the tree one by one.
constexpr int kLeastForPacket = 4;
/// Things nearer to a light than this share of the distance do not hide it: rounding of the light's
/// point.
constexpr double kBeforeLight = 1.0 - 1e-9;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

const char* pinned_isa() { return __builtin_cpu_supports("avx2") ? "avx2" : "sse4.2"; }

/// A mesh in the world frame.
struct WorldMesh {
    int shape = 0;
    bool see_through = false;
    std::vector<FacetPlane> planes;
    std::vector<Vec3> normals;  ///< one a vertex, or empty: flat
    std::optional<ConvexSolid> solid;
    const std::vector<std::array<std::uint32_t, 3>>* triangles = nullptr;
};

/// One Embree query: its double-precision side, which the callbacks reach through the context.
struct Query {
    RTCIntersectContext context;  // must be first
    const RayLanes* rays;
    std::array<double, kMaxLanes> t;  ///< nearest hit so far; the limit, for shadow rays
    /// Where Embree's ray starts, along the true one: rays from afar at the scene's edge, because
    /// its
    /// precision is that of the distance.
    std::array<double, kMaxLanes> start;
    double scale;
    bool back = false;     ///< looks for the way out that a ray had at its very start
    bool way_out = false;  ///< looks for ways out of the body that the ray is in, and nothing else
};
/// Whether the vertex normals, if any, say no more than the triangles themselves.
bool normals_are_flat(const Mesh& mesh, const WorldMesh& world) {
    constexpr double kSameNormal = 1e-5;  // normals in files are floats or less
    if (world.normals.empty()) return true;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t corner : mesh.triangles[i]) {
            const Vec3 apart = normalised(world.normals[corner]) - world.planes[i].normal;
            if (!(dot(apart, apart) < kSameNormal * kSameNormal)) return false;
        }
    return true;
}

Query& query_of(RTCIntersectContext* context) { return *reinterpret_cast<Query*>(context); }

}  // namespace

struct Accelerator::Tree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double scale = 1.0;
    Vec3 centre;  ///< of a ball around all bounded shapes
    double radius = std::numeric_limits<double>::infinity();
    std::vector<WorldMesh> meshes;        // geometry ID = index
    std::vector<AnalyticShape> analytic;  // bounded ones, one user geometry after the meshes
    std::vector<int> analytic_shape;      // index into Scene::shapes
    std::vector<Bounds> analytic_bounds;
    std::vector<AnalyticShape> planes;
    std::vector<int> plane_shape;
    std::vector<int> mesh_of_shape;      // index into meshes, −1 for analytic shapes
    std::vector<int> analytic_of_shape;  // index into analytic, −1 for the others
    std::vector<bool> see_through;
    /// One a shape: convex, with nothing else inside, so that rays within it need not ask the tree.
    std::vector<bool> undisturbed;

    LaneMask leave_undisturbed(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    void intersect(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    double start_of(const Ray& ray) const;
    void look_back(const RayLanes& rays, int k, Hit& hit) const;
    void add_mesh(const Shape& shape, int index);
    void attach_analytic();
    void finish_lane(const RayLanes& rays, int k, Hit& hit) const;
    void meet_planes(const RayLanes& rays, int k, Hit& hit) const;

    template <bool kOccluded>
    static void filter(const RTCFilterFunctionNArguments* args);
    template <bool kOccluded>
    void meet_analytic(RTCIntersectContext* context, unsigned primitive, unsigned n,
                       const int* valid, RTCRayN* ray, RTCHitN* hit, unsigned geometry) const;
};

/// Called for each triangle that Embree believes to be hit: measures again in double precision, and
/// refuses the triangle that the ray starts on.
template <bool kOccluded>
void Accelerator::Tree::filter(const RTCFilterFunctionNArguments* args) {
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
        if (!accept)
            args->valid[i] = 0;
        else if (!kOccluded)
            query.t[k] = t;
    }
}

template <bool kOccluded>
void Accelerator::Tree::meet_analytic(RTCIntersectContext* context, unsigned primitive, unsigned n,
                                      const int* valid, RTCRayN* ray, RTCHitN* hit,
                                      unsigned geometry) const {
    Query& query = query_of(context);
    if (query.back || query.way_out) return;
    const AnalyticShape& shape = analytic[primitive];
    const int index = analytic_shape[primitive];
    if (kOccluded && see_through[std::size_t(index)]) return;
    for (unsigned i = 0; i < n; ++i) {
        if (valid[i] != -1) continue;
        const unsigned k = RTCRayN_id(ray, n, i);
        const RayLanes& rays = *query.rays;
        const SurfaceFrom& from = rays.from[k];
        double t = 0.0;
        int face = 0;
        if (!shape.intersect(rays.origin(int(k)), rays.direction(int(k)), from.shape == index,
                             from.inward, query.t[k], t, face))
            continue;
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

void Accelerator::Tree::add_mesh(const Shape& shape, int index) {
    const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(shape.geometry);
    WorldMesh& world = meshes.emplace_back();
    world.shape = index;
    world.see_through = see_through[std::size_t(index)];
    world.triangles = &mesh.triangles;
    std::vector<Vec3> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const auto& v : mesh.vertices) vertices.push_back(shape.world_from_object(v).v);
    for (const auto& n : mesh.normals) world.normals.push_back(shape.world_from_object(n).v);
    // A mirrored frame turns the winding round; normals stay outward.
    const double side = shape.world_from_object.affine().determinant() < 0.0 ? -1.0 : 1.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 n = side * cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
        const Vec3 unit_normal = length(n) > 0.0 ? normalised(n) : Vec3{0, 0, 1};
        world.planes.push_back({unit_normal, dot(unit_normal, vertices[a])});
    }
    if (normals_are_flat(mesh, world)) {
        world.normals.clear();
        world.solid =
            ConvexSolid::from_triangles(vertices, mesh.triangles, world.planes, kSamePlane * scale);
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* floats = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               vertices.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            floats[3 * i + std::size_t(axis)] = float(vertices[i][axis]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), indices + 3 * i);
    rtcSetGeometryIntersectFilterFunction(geometry, &filter<false>);
    rtcSetGeometryOccludedFilterFunction(geometry, &filter<true>);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, unsigned(meshes.size() - 1));
    rtcReleaseGeometry(geometry);
}

void Accelerator::Tree::attach_analytic() {
    if (analytic.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(analytic.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(
        geometry,
        [](const RTCBoundsFunctionArguments* args) {
            const auto& tree = *static_cast<const Tree*>(args->geometryUserPtr);
            const Bounds& b = tree.analytic_bounds[args->primID];
            // Wider by the rounding to float, and by more, so that flat shapes have a volume.
            const double margin = 1e-6 * (tree.scale + length(b.high) + length(b.low));
            *args->bounds_o = {
                float(b.low.x - margin),  float(b.low.y - margin),  float(b.low.z - margin),  0.0f,
                float(b.high.x + margin), float(b.high.y + margin), float(b.high.z + margin), 0.0f};
        },
        nullptr);
    rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* args) {
        static_cast<const Tree*>(args->geometryUserPtr)
            ->meet_analytic<false>(args->context, args->primID, args->N, args->valid,
                                   RTCRayHitN_RayN(args->rayhit, args->N),
                                   RTCRayHitN_HitN(args->rayhit, args->N), args->geomID);
    });
    rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments* args) {
        static_cast<const Tree*>(args->geometryUserPtr)
            ->meet_analytic<true>(args->context, args->primID, args->N, args->valid, args->ray,
                                  nullptr, args->geomID);
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, unsigned(meshes.size()));
    rtcReleaseGeometry(geometry);
}

Accelerator::Accelerator(const Scene& scene, std::vector<bool> see_through)
    : tree_(std::make_unique<Tree>()) {
    Tree& tree = *tree_;
    const std::string config = std::string("isa=") + pinned_isa() +
                               (parallel_backend_is_jthread() ? ",threads=1,user_threads=1" : "");
    tree.device = rtcNewDevice(config.c_str());
    DEWBOW_CHECK(tree.device != nullptr, "Embree gives no device");
    tree.scene = rtcNewScene(tree.device);
    rtcSetSceneFlags(tree.scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(tree.scene, RTC_BUILD_QUALITY_HIGH);
    tree.see_through = std::move(see_through);
    const Bounds bounds = bounds_of(scene);
    if (!bounds.empty()) {
        tree.scale = std::max(length(bounds.low), length(bounds.high));
        tree.centre = bounds.centre();
        tree.radius = bounds.radius() + 0.01 * tree.scale;
    }

    std::size_t mesh_count = 0;
    for (const Shape& shape : scene.shapes) mesh_count += !AnalyticShape::holds(shape.geometry);
    tree.meshes.reserve(mesh_count);  // the filter holds pointers into it
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        tree.mesh_of_shape.push_back(-1);
        tree.analytic_of_shape.push_back(-1);
        if (!AnalyticShape::holds(shape.geometry)) {
            tree.mesh_of_shape.back() = int(tree.meshes.size());
            tree.add_mesh(shape, int(i));
        } else if (AnalyticShape analytic(shape, kSamePlane * tree.scale); analytic.infinite()) {
            tree.planes.push_back(analytic);
            tree.plane_shape.push_back(int(i));
        } else {
            tree.analytic_of_shape.back() = int(tree.analytic.size());
            tree.analytic.push_back(analytic);
            tree.analytic_shape.push_back(int(i));
            tree.analytic_bounds.push_back(bounds_of(shape));
        }
    }
    for (std::size_t i = 0; i < tree.meshes.size(); ++i)
        rtcSetGeometryUserData(rtcGetGeometry(tree.scene, unsigned(i)), &tree.meshes[i]);
    tree.attach_analytic();
    std::vector<const ConvexSolid*> solids;
    for (const int mesh : tree.mesh_of_shape) {
        const bool convex = mesh >= 0 && tree.meshes[std::size_t(mesh)].solid;
        solids.push_back(convex ? &*tree.meshes[std::size_t(mesh)].solid : nullptr);
    }
    tree.undisturbed = find_undisturbed(scene, solids);
    rtcCommitScene(tree.scene);
    const RTCError error = rtcGetDeviceError(tree.device);
    DEWBOW_CHECK(error == RTC_ERROR_NONE, "Embree could not build the scene");
}

Accelerator::~Accelerator() {
    if (tree_->scene) rtcReleaseScene(tree_->scene);
    if (tree_->device) rtcReleaseDevice(tree_->device);
}

void Accelerator::Tree::meet_planes(const RayLanes& rays, int k, Hit& hit) const {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        double t = 0.0;
        int face = 0;
        const SurfaceFrom& from = rays.from[std::size_t(k)];
        if (!planes[i].intersect(rays.origin(k), rays.direction(k), from.shape == plane_shape[i],
                                 from.inward, hit.t, t, face))
            continue;
        hit.t = t;
        hit.shape = plane_shape[i];
        hit.primitive = 0;
        hit.normal = planes[i].normal({}, 0);
    }
}

namespace {

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

/// @param limit  along the true ray.
RTCRay load_ray(const Query& query, int k, double limit) {
    const double start = query.start[std::size_t(k)];
    const Vec3 d = query.rays->direction(k), origin = query.rays->origin(k) + d * start;
    RTCRay result{};
    result.org_x = float(origin.x), result.org_y = float(origin.y), result.org_z = float(origin.z);
    result.dir_x = float(d.x), result.dir_y = float(d.y), result.dir_z = float(d.z);
    result.tnear = 0.0f;
    result.tfar = float(limit - start);
    result.mask = ~0u;
    result.id = unsigned(k);
    return result;
}

RTCRayHit load_ray_hit(const Query& query, int k, double limit) {
    RTCRayHit result;
    result.ray = load_ray(query, k, limit);
    result.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    result.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return result;
}

Query make_query(const RayLanes& rays, double limit, double scale, bool coherent) {
    Query query;
    rtcInitIntersectContext(&query.context);
    query.context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    query.rays = &rays;
    query.t.fill(limit);
    query.start.fill(0.0);
    query.scale = scale;
    return query;
}

}  // namespace

/// Fills in what Embree's record leaves out; `hit` holds geometry and primitive IDs.
void Accelerator::Tree::finish_lane(const RayLanes& rays, int k, Hit& hit) const {
    if (hit.shape < 0) {
        hit.t = kUnlimited;
    } else if (std::size_t(hit.shape) < meshes.size()) {
        const WorldMesh& mesh = meshes[std::size_t(hit.shape)];
        hit.shape = mesh.shape;
        hit.normal = mesh.planes[std::size_t(hit.primitive)].normal;
    } else {
        const auto which = std::size_t(hit.primitive);
        hit.shape = analytic_shape[which];
        hit.primitive = int(hit.u);
        hit.normal =
            analytic[which].normal(rays.origin(k) + rays.direction(k) * hit.t, hit.primitive);
    }
    if (!planes.empty()) meet_planes(rays, k, hit);
}

/// Lanes that are inside a body with nothing in it: their hits, without the tree. Returns the
/// others.
LaneMask Accelerator::Tree::leave_undisturbed(const RayLanes& rays, LaneMask mask,
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
        const int mesh = mesh_of_shape[std::size_t(from.shape)];
        if (mesh >= 0) {
            meshes[std::size_t(mesh)].solid->leave(rays, group, hits);
            continue;
        }
        const AnalyticShape& shape =
            analytic[std::size_t(analytic_of_shape[std::size_t(from.shape)])];
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
double Accelerator::Tree::start_of(const Ray& ray) const {
    const double at_edge = dot(centre - ray.origin, ray.direction) - radius;
    if (at_edge > 0.0) return at_edge;
    return ray.from.shape >= 0 ? -kHeadStart * scale : 0.0;
}

/// A ray that went inward from a mesh has not met the way out, but something else or nothing. Where
/// it started near an edge, Embree's ray may run outside, beside that edge; then the neighbouring
/// triangle is the way out, at once. So Embree gets a ray that starts a little further back and
/// inward. (No body may be left unseen: its inside would be taken for the world.)
void Accelerator::Tree::look_back(const RayLanes& rays, int k, Hit& hit) const {
    const SurfaceFrom& from = rays.from[std::size_t(k)];
    const WorldMesh& mesh = meshes[std::size_t(mesh_of_shape[std::size_t(from.shape)])];
    const Vec3 inward = mesh.planes[std::size_t(from.primitive)].normal * (-kTouch * scale);
    Query query = make_query(rays, hit.t, scale, false);
    query.back = true;
    query.start[std::size_t(k)] = -kLookBack * scale;
    RTCRayHit single = load_ray_hit(query, k, kLookBack * scale);
    single.ray.org_x += float(inward.x);
    single.ray.org_y += float(inward.y);
    single.ray.org_z += float(inward.z);
    rtcIntersect1(scene, &query.context, &single);
    if (single.hit.geomID == RTC_INVALID_GEOMETRY_ID && hit) {
        // What was hit may be what the body stands on, met at the very distance of the way out.
        query = make_query(rays, hit.t + kSamePlane * scale, scale, false);
        query.way_out = true;
        single = load_ray_hit(query, k, hit.t + kHeadStart * scale);
        rtcIntersect1(scene, &query.context, &single);
    }
    if (single.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    hit.shape = int(single.hit.geomID);
    hit.primitive = int(single.hit.primID);
    hit.u = double(single.hit.u);
    hit.v = double(single.hit.v);
    hit.t = query.t[std::size_t(k)];
    finish_lane(rays, k, hit);
}

Hit Accelerator::intersect(const Ray& ray) const {
    RayLanes rays;
    rays.count = 1;
    rays.set(0, ray);
    Hit hit;
    tree_->intersect(rays, 1u, std::span(&hit, 1));
    return hit;
}

void Accelerator::intersect(const RayLanes& rays, LaneMask mask, HitLanes& hits) const {
    tree_->intersect(rays, mask, hits);
}

void Accelerator::Tree::intersect(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const {
    mask = leave_undisturbed(rays, mask, hits);
    if (!mask) return;
    Query query = make_query(rays, kUnlimited, scale, rays.count > 1);
    for (LaneMask m = mask; m; m &= m - 1) {
        const int k = std::countr_zero(m);
        query.start[std::size_t(k)] = start_of(rays.ray(k));
    }
    const auto finish = [&](int k, unsigned geometry, unsigned primitive, float u, float v) {
        Hit& hit = hits[std::size_t(k)];
        hit.shape = int(geometry);
        hit.primitive = int(primitive);
        hit.u = double(u);
        hit.v = double(v);
        hit.t = query.t[std::size_t(k)];
        finish_lane(rays, k, hit);
        const SurfaceFrom& from = rays.from[std::size_t(k)];
        if (from.inward && mesh_of_shape[std::size_t(from.shape)] >= 0 &&
            !(hit.shape == from.shape && dot(hit.normal, rays.direction(k)) > 0.0))
            look_back(rays, k, hit);
    };
    if (std::popcount(mask) < kLeastForPacket) {
        for (LaneMask m = mask; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            RTCRayHit single = load_ray_hit(query, k, kUnlimited);
            rtcIntersect1(scene, &query.context, &single);
            finish(k, single.hit.geomID, single.hit.primID, single.hit.u, single.hit.v);
        }
        return;
    }
    alignas(64) std::array<int, kMaxLanes> valid;
    for (int k = 0; k < kMaxLanes; ++k) valid[std::size_t(k)] = (mask >> k & 1u) ? -1 : 0;
    const auto trace_packet = [&](auto& packet, auto&& trace, int width) {
        load_rays(query, width, packet);
        trace(valid.data(), scene, &query.context, &packet);
        for (LaneMask m = mask; m; m &= m - 1) {
            const int k = std::countr_zero(m);
            finish(k, packet.hit.geomID[k], packet.hit.primID[k], packet.hit.u[k], packet.hit.v[k]);
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

bool Accelerator::occluded(const Ray& ray, double distance) const {
    const Tree& tree = *tree_;
    RayLanes rays;
    rays.count = 1;
    rays.set(0, ray);
    const double limit = distance * kBeforeLight;
    const SurfaceFrom& from = ray.from;
    const bool in_body = from.inward && !tree.see_through[std::size_t(from.shape)];
    if (in_body && tree.undisturbed[std::size_t(from.shape)]) {
        Hit hit;
        tree.leave_undisturbed(rays, 1u, std::span(&hit, 1));
        return hit.t < limit;
    }
    for (std::size_t i = 0; i < tree.planes.size(); ++i) {
        double t = 0.0;
        int face = 0;
        const int shape = tree.plane_shape[i];
        if (!tree.see_through[std::size_t(shape)] &&
            tree.planes[i].intersect(ray.origin, ray.direction, ray.from.shape == shape,
                                     ray.from.inward, limit, t, face))
            return true;
    }
    Query query = make_query(rays, limit, tree.scale, false);
    query.start[0] = tree.start_of(ray);
    if (query.start[0] >= limit) return false;
    RTCRay single = load_ray(query, 0, limit);
    rtcOccluded1(tree.scene, &query.context, &single);
    if (single.tfar < 0.0f) return true;
    if (!in_body || tree.mesh_of_shape[std::size_t(from.shape)] < 0) return false;
    // Out of a mesh without meeting it? Only if the slower query agrees, which looks beside edges
    // too.
    Hit hit;
    tree.intersect(rays, 1u, std::span(&hit, 1));
    return hit.shape == from.shape && hit.t < limit;
}

Vec3 Accelerator::shading_normal(const Hit& hit) const {
    if (flat(hit.shape)) return hit.normal;
    const WorldMesh& mesh =
        tree_->meshes[std::size_t(tree_->mesh_of_shape[std::size_t(hit.shape)])];
    const auto& [a, b, c] = (*mesh.triangles)[std::size_t(hit.primitive)];
    const Vec3 n =
        mesh.normals[a] * (1.0 - hit.u - hit.v) + mesh.normals[b] * hit.u + mesh.normals[c] * hit.v;
    const double squared = dot(n, n);
    if (!(squared > 0.0) || dot(n, hit.normal) <= 0.0) return hit.normal;
    return n / std::sqrt(squared);
}

bool Accelerator::flat(int shape) const {
    const int which = tree_->mesh_of_shape[std::size_t(shape)];
    return which < 0 || tree_->meshes[std::size_t(which)].normals.empty();
}

std::string accelerator_fingerprint() {
    return std::string("Embree ") + RTC_VERSION_STRING + " " + pinned_isa();
}

}  // namespace dewbow
