// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inside of the accelerator, shared by the three files that make it: accelerator_build.cpp
// hands shapes to Embree, accelerator_query.cpp hands it rays, accelerator_callbacks.cpp answers
// what Embree asks about each triangle on the way.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/render/analytic_shape.h"
#include "dewbow/render/convex_solid.h"
#include "dewbow/render/opacity.h"
#include "dewbow/render/ray.h"
#include "dewbow/scene/scene.h"

// Of Embree, whose header stays in .cpp files.
struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCBoundsFunctionArguments;
struct RTCFilterFunctionNArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace dewbow {

/// A ray whose origin is nearer to a triangle's plane than this times the size of the coordinates
/// starts on it: it left the other triangle of a flat facet, or a body that stands on it. Some
/// hundred times the rounding of that distance.
inline constexpr double kSamePlane = 1e-13;
/// Embree's single precision may put the start of a ray on the wrong side of a triangle that is
/// nearer than this times the size of the coordinates: 16 roundings.
inline constexpr double kTouch = 1e-6;

/// A mesh in the world frame.
struct WorldMesh {
    int shape = 0;
    bool see_through = false;
    const Opacity* opacity = nullptr;  ///< nullptr: opaque everywhere
    std::vector<FacetPlane> planes;
    std::vector<Vec3> normals;  ///< one a vertex, or empty: flat
    std::optional<ConvexSolid> solid;
    const Mesh* mesh = nullptr;
    const Transform<World, Object>* world_from_object = nullptr;
};

/// The double-precision side of one Embree query.
struct Query {
    const RayLanes* rays;
    std::array<double, kMaxLanes> t;  ///< nearest hit so far; the limit, for shadow rays
    /// Where Embree's ray starts, along the true one: rays from afar at the scene's edge, because
    /// its precision is that of the distance.
    std::array<double, kMaxLanes> start;
    double scale;
    bool back = false;     ///< looks for the way out that a ray had at its very start
    bool way_out = false;  ///< looks for ways out of the body that the ray is in, and nothing else
};
/// What Embree hands through to its callbacks: its own context, and behind it the query.
template <class EmbreeContext>
struct QueryContext {
    EmbreeContext embree;
    Query query;
};

struct AcceleratorTree {
    AcceleratorTree(const Scene& scene, std::vector<bool> see_through, const Opacity* opacity);
    ~AcceleratorTree();
    AcceleratorTree(const AcceleratorTree&) = delete;
    AcceleratorTree& operator=(const AcceleratorTree&) = delete;

    void intersect(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    bool occluded(const Ray& ray, double distance) const;

    /// Nearest place before `limit` where lane k meets an analytic shape, and it is there. Sets t
    /// and face.  @param index  of the shape in Scene::shapes.
    bool meet(const AnalyticShape& shape, int index, const RayLanes& rays, int k, double limit,
              double& t, int& face) const;

    /// The mesh of that shape, or nullptr for analytic shapes.
    const WorldMesh* mesh_of(int shape) const {
        const int which = mesh_of_shape[std::size_t(shape)];
        return which < 0 ? nullptr : &meshes[std::size_t(which)];
    }
    /// That shape, if it is no mesh.
    const AnalyticShape& analytic_at(int shape) const {
        const int which = analytic_of_shape[std::size_t(shape)];
        return which < 0 ? planes[std::size_t(-1 - which)] : analytic[std::size_t(which)];
    }

    RTCDeviceTy* device = nullptr;
    RTCSceneTy* scene = nullptr;
    double scale = 1.0;  ///< of the coordinates, metres: what roundings are measured by
    Vec3 centre;         ///< of a ball around all bounded shapes
    double radius = std::numeric_limits<double>::infinity();
    std::vector<WorldMesh> meshes;        // geometry ID = index
    std::vector<AnalyticShape> analytic;  // bounded ones, one user geometry after the meshes
    std::vector<int> analytic_shape;      // index into Scene::shapes
    std::vector<Bounds> analytic_bounds;
    std::vector<AnalyticShape> planes;
    std::vector<int> plane_shape;
    std::vector<int> mesh_of_shape;      // index into meshes, −1 for analytic shapes
    std::vector<int> analytic_of_shape;  // index into analytic; −1 − index into planes for those
    std::vector<bool> see_through;
    const Opacity* opacity = nullptr;
    std::vector<bool> partly_there;  ///< one a shape: whether to ask `opacity`
    /// One a shape: convex, with nothing else inside, so that rays within it need not ask the tree.
    std::vector<bool> undisturbed;

private:
    void add_shape(const Shape& shape, int index);
    void add_mesh(const Shape& shape, int index);
    void attach_triangles(const Mesh& mesh, const std::vector<Vec3>& vertices);
    void attach_analytic();
    const Opacity* opacity_of(int shape) const {
        return partly_there[std::size_t(shape)] ? opacity : nullptr;
    }

    LaneMask leave_undisturbed(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    double start_of(const Ray& ray) const;
    void look_back(const RayLanes& rays, int k, Hit& hit) const;
    void finish_lane(const RayLanes& rays, int k, Hit& hit) const;
    void meet_planes(const RayLanes& rays, int k, Hit& hit) const;
};

const char* embree_isa();

/// What Embree calls. The user pointer of a mesh's geometry is its WorldMesh, that of the analytic
/// shapes the AcceleratorTree.
namespace embree_callbacks {
void measure_hit(const RTCFilterFunctionNArguments* args);
void measure_shadow(const RTCFilterFunctionNArguments* args);
void bound_analytic(const RTCBoundsFunctionArguments* args);
void meet_analytic(const RTCIntersectFunctionNArguments* args);
void shadow_analytic(const RTCOccludedFunctionNArguments* args);
}  // namespace embree_callbacks

}  // namespace dewbow
