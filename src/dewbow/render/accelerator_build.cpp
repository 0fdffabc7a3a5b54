// SPDX-License-Identifier: Apache-2.0
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "dewbow/base/check.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/accelerator_tree.h"
#include "dewbow/render/undisturbed.h"

namespace dewbow {

namespace {

/// Meshes with more triangles than this in all their shapes together are shared by these, if there
/// are several. Below it memory is no matter (170 bytes a triangle, docs/scene-size.md), and convex
/// stones of their own know their ways out (ConvexSolid).
constexpr std::size_t kMostWorldTriangles = 200'000;
/// What a shape costs besides its triangles, in triangles.
constexpr std::size_t kShapeCost = 10;

/// Whether the vertex normals (of the same frame as the planes), if any, say no more than the
/// triangles themselves.
bool normals_are_flat(const Mesh& mesh, const std::vector<Vec3>& normals,
                      const std::vector<FacetPlane>& planes) {
    constexpr double kSameNormal = 1e-5;  // normals in files are floats or less
    if (normals.empty()) return true;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t corner : mesh.triangles[i]) {
            const Vec3 apart = normalised(normals[corner]) - planes[i].normal;
            if (!(dot(apart, apart) < kSameNormal * kSameNormal)) return false;
        }
    return true;
}

/// @param side  −1 in a mirrored frame, which turns the winding round; normals stay outward.
std::vector<FacetPlane> planes_of(const std::vector<Vec3>& vertices, const Mesh& mesh,
                                  double side) {
    std::vector<FacetPlane> planes;
    planes.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 n = side * cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
        const Vec3 unit_normal = length(n) > 0.0 ? normalised(n) : Vec3{0, 0, 1};
        planes.push_back({unit_normal, dot(unit_normal, vertices[a])});
    }
    return planes;
}

/// Triangles for Embree, relative to `centre`.
RTCGeometry make_triangles(RTCDevice device, const Mesh& mesh, const std::vector<Vec3>& vertices,
                           Vec3 centre, void* user, RTCFilterFunctionN hit,
                           RTCFilterFunctionN shadow) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* floats = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               vertices.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    DEWBOW_CHECK(floats && indices, "Embree has no memory for a mesh");
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 v = vertices[i] - centre;
        for (int axis = 0; axis < 3; ++axis) floats[3 * i + std::size_t(axis)] = float(v[axis]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), indices + 3 * i);
    rtcSetGeometryUserData(geometry, user);
    rtcSetGeometryIntersectFilterFunction(geometry, hit);
    rtcSetGeometryOccludedFilterFunction(geometry, shadow);
    rtcCommitGeometry(geometry);
    return geometry;
}

RTCScene make_scene(RTCDevice device) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    return scene;
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

/// A bound of how much longer a map makes a vector: √(‖A‖₁ ‖A‖∞).
double most_stretch(const Affine& a) {
    double row_most = 0.0;
    std::array<double, 3> column{};
    for (const auto& row : a.m) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            sum += std::abs(row[i]);
            column[i] += std::abs(row[i]);
        }
        row_most = std::max(row_most, sum);
    }
    return std::sqrt(row_most * *std::max_element(column.begin(), column.end()));
}

}  // namespace

const char* embree_isa() { return __builtin_cpu_supports("avx2") ? "avx2" : "sse4.2"; }

void AcceleratorTree::add_mesh(const Shape& shape, int index) {
    const Mesh& mesh = mesh_of(index);
    WorldMesh& world = meshes.emplace_back();
    world.shape = index;
    world.see_through = see_through[std::size_t(index)];
    world.opacity = opacity_of(index);
    std::vector<Vec3> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const auto& v : mesh.vertices) vertices.push_back(shape.world_from_object(v).v);
    for (const auto& n : mesh.normals) world.normals.push_back(shape.world_from_object(n).v);
    const bool mirrored = shape.world_from_object.affine().determinant() < 0.0;
    world.planes = planes_of(vertices, mesh, mirrored ? -1.0 : 1.0);
    if (normals_are_flat(mesh, world.normals, world.planes)) {
        world.normals.clear();
        if (!world.opacity)
            world.solid = ConvexSolid::from_triangles(vertices, mesh.triangles, world.planes,
                                                      kSamePlane * scale);
    }
    attach(scene,
           make_triangles(device, mesh, vertices, {}, &world, &embree_callbacks::measure_hit,
                          &embree_callbacks::measure_shadow),
           unsigned(meshes.size() - 1));
}

void AcceleratorTree::add_shared(const Mesh& mesh) {
    SharedMesh& added = shared.emplace_back();
    added.mesh = &mesh;
    std::vector<Vec3> vertices, normals;
    vertices.reserve(mesh.vertices.size());
    for (const auto& v : mesh.vertices) {
        vertices.push_back(v.v);
        added.bounds.add(v.v);
    }
    for (const auto& n : mesh.normals) normals.push_back(n.v);
    added.planes = planes_of(vertices, mesh, 1.0);
    added.flat = normals_are_flat(mesh, normals, added.planes);
    added.scene = make_scene(device);
    attach(added.scene,
           make_triangles(device, mesh, vertices, added.bounds.centre(), this,
                          &embree_callbacks::measure_instance_hit,
                          &embree_callbacks::measure_instance_shadow),
           0);
    rtcCommitScene(added.scene);
}

/// Decides which meshes are shared and which stand in the world, one for each shape.
void AcceleratorTree::share_meshes() {
    std::unordered_map<const Mesh*, std::size_t> uses;
    for (const Shape& shape : described.shapes)
        if (const Mesh* mesh = mesh_of_geometry(shape)) ++uses[mesh];
    std::size_t in_world = 0;
    for (const Shape& shape : described.shapes) {
        const Mesh* mesh = mesh_of_geometry(shape);
        if (!mesh) continue;
        const std::size_t count = uses[mesh];
        if (count == 1 || count * (mesh->triangles.size() + kShapeCost) <= kMostWorldTriangles)
            ++in_world;
        else if (shared_index.emplace(mesh, int(shared.size())).second)
            add_shared(*mesh);
    }
    meshes.reserve(in_world);  // the callbacks hold pointers into it
}

void AcceleratorTree::add_shape(const Shape& shape, int index) {
    if (const Mesh* mesh = mesh_of_geometry(shape)) {
        const auto found = shared_index.find(mesh);
        if (found == shared_index.end()) {
            places.push_back({Kind::world_mesh, int(meshes.size())});
            add_mesh(shape, index);
            return;
        }
        constexpr double kMargin = 1.01;  // for single precision, with room to spare
        places.push_back({Kind::instance, int(instances.size())});
        instances.push_back({index, found->second, opacity_of(index),
                             kMargin * shared[std::size_t(found->second)].bounds.radius() *
                                 most_stretch(shape.world_from_object.affine())});
        return;
    }
    AnalyticShape one(shape, kSamePlane * scale);
    const bool plane = one.infinite();
    std::vector<AnalyticShape>& all = plane ? planes : analytic;
    places.push_back({plane ? Kind::plane : Kind::analytic, int(all.size())});
    all.push_back(std::move(one));
    (plane ? plane_shape : analytic_shape).push_back(index);
}

void AcceleratorTree::attach_analytic() {
    if (analytic.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(analytic.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, &embree_callbacks::bound_analytic, nullptr);
    rtcSetGeometryIntersectFunction(geometry, &embree_callbacks::meet_analytic);
    rtcSetGeometryOccludedFunction(geometry, &embree_callbacks::shadow_analytic);
    rtcCommitGeometry(geometry);
    attach(scene, geometry, analytic_geometry());
}

void AcceleratorTree::attach_instances() {
    if (instances.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(instances.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, &embree_callbacks::bound_instance, nullptr);
    rtcSetGeometryIntersectFunction(geometry, &embree_callbacks::meet_instance);
    rtcSetGeometryOccludedFunction(geometry, &embree_callbacks::shadow_instance);
    rtcCommitGeometry(geometry);
    attach(scene, geometry, instance_geometry());
}

std::vector<bool> AcceleratorTree::find_all_undisturbed() const {
    std::vector<const ConvexSolid*> solids;
    for (std::size_t i = 0; i < places.size(); ++i) solids.push_back(solid_of(int(i)));
    std::vector<bool> result = find_undisturbed(described, solids);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] && !partly_there[i];
    return result;
}

AcceleratorTree::AcceleratorTree(const Scene& to_trace, std::vector<bool> transparent,
                                 const Opacity* partly)
    : described(to_trace), see_through(std::move(transparent)), opacity(partly) {
    const std::string config = std::string("isa=") + embree_isa() +
                               (parallel_backend_is_jthread() ? ",threads=1,user_threads=1" : "");
    device = rtcNewDevice(config.c_str());
    DEWBOW_CHECK(device != nullptr, "Embree gives no device");
    scene = make_scene(device);
    const Bounds bounds = bounds_of(described);
    if (!bounds.empty()) {
        scale = std::max(length(bounds.low), length(bounds.high));
        centre = bounds.centre();
        radius = bounds.radius() + 0.01 * scale;
    }
    for (std::size_t i = 0; i < described.shapes.size(); ++i)
        partly_there.push_back(opacity && opacity->tests(int(i)));
    share_meshes();
    for (std::size_t i = 0; i < described.shapes.size(); ++i)
        add_shape(described.shapes[i], int(i));
    attach_analytic();
    attach_instances();
    undisturbed = find_all_undisturbed();
    rtcCommitScene(scene);
    const RTCError error = rtcGetDeviceError(device);
    DEWBOW_CHECK(error == RTC_ERROR_NONE, "Embree could not build the scene");
}

AcceleratorTree::~AcceleratorTree() {
    for (const SharedMesh& mesh : shared) rtcReleaseScene(mesh.scene);
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
}

}  // namespace dewbow
