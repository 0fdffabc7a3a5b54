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

}  // namespace

const char* embree_isa() { return __builtin_cpu_supports("avx2") ? "avx2" : "sse4.2"; }

void AcceleratorTree::add_mesh(const Shape& shape, int index) {
    const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(shape.geometry);
    WorldMesh& world = meshes.emplace_back();
    world.shape = index;
    world.see_through = see_through[std::size_t(index)];
    world.opacity = opacity_of(index);
    world.mesh = &mesh;
    world.world_from_object = &shape.world_from_object;
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
        if (!world.opacity)
            world.solid = ConvexSolid::from_triangles(vertices, mesh.triangles, world.planes,
                                                      kSamePlane * scale);
    }
    attach_triangles(mesh, vertices);
}

void AcceleratorTree::attach_triangles(const Mesh& mesh, const std::vector<Vec3>& vertices) {
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
    rtcSetGeometryIntersectFilterFunction(geometry, &embree_callbacks::measure_hit);
    rtcSetGeometryOccludedFilterFunction(geometry, &embree_callbacks::measure_shadow);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, unsigned(meshes.size() - 1));
    rtcReleaseGeometry(geometry);
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
    rtcAttachGeometryByID(scene, geometry, unsigned(meshes.size()));
    rtcReleaseGeometry(geometry);
}

void AcceleratorTree::add_shape(const Shape& shape, int index) {
    mesh_of_shape.push_back(-1);
    analytic_of_shape.push_back(-1);
    if (!AnalyticShape::holds(shape.geometry)) {
        mesh_of_shape.back() = int(meshes.size());
        add_mesh(shape, index);
    } else if (AnalyticShape one(shape, kSamePlane * scale); one.infinite()) {
        analytic_of_shape.back() = -1 - int(planes.size());
        planes.push_back(one);
        plane_shape.push_back(index);
    } else {
        analytic_of_shape.back() = int(analytic.size());
        analytic.push_back(one);
        analytic_shape.push_back(index);
        analytic_bounds.push_back(bounds_of(shape));
    }
}

AcceleratorTree::AcceleratorTree(const Scene& described, std::vector<bool> transparent,
                                 const Opacity* partly)
    : see_through(std::move(transparent)), opacity(partly) {
    const std::string config = std::string("isa=") + embree_isa() +
                               (parallel_backend_is_jthread() ? ",threads=1,user_threads=1" : "");
    device = rtcNewDevice(config.c_str());
    DEWBOW_CHECK(device != nullptr, "Embree gives no device");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    const Bounds bounds = bounds_of(described);
    if (!bounds.empty()) {
        scale = std::max(length(bounds.low), length(bounds.high));
        centre = bounds.centre();
        radius = bounds.radius() + 0.01 * scale;
    }

    for (std::size_t i = 0; i < described.shapes.size(); ++i)
        partly_there.push_back(opacity && opacity->tests(int(i)));
    std::size_t mesh_count = 0;
    for (const Shape& shape : described.shapes) mesh_count += !AnalyticShape::holds(shape.geometry);
    meshes.reserve(mesh_count);  // the callbacks hold pointers into it
    for (std::size_t i = 0; i < described.shapes.size(); ++i)
        add_shape(described.shapes[i], int(i));
    for (std::size_t i = 0; i < meshes.size(); ++i)
        rtcSetGeometryUserData(rtcGetGeometry(scene, unsigned(i)), &meshes[i]);
    attach_analytic();
    std::vector<const ConvexSolid*> solids;
    for (const int mesh : mesh_of_shape) {
        const bool convex = mesh >= 0 && meshes[std::size_t(mesh)].solid;
        solids.push_back(convex ? &*meshes[std::size_t(mesh)].solid : nullptr);
    }
    undisturbed = find_undisturbed(described, solids);
    for (std::size_t i = 0; i < undisturbed.size(); ++i)
        undisturbed[i] = undisturbed[i] && !partly_there[i];
    rtcCommitScene(scene);
    const RTCError error = rtcGetDeviceError(device);
    DEWBOW_CHECK(error == RTC_ERROR_NONE, "Embree could not build the scene");
}

AcceleratorTree::~AcceleratorTree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
}

}  // namespace dewbow
