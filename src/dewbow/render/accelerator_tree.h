// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inside of the accelerator, shared by the files that make it: accelerator_build.cpp hands
// shapes to Embree, accelerator_query.cpp hands it rays, accelerator_callbacks.cpp answers what
// Embree asks on the way, accelerator_surface.cpp describes where a hit is.

#include <optional>
#include <span>
#include <unordered_map>
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

/// The mesh of one shape, in the world frame.
struct WorldMesh {
    int shape = 0;
    bool see_through = false;
    const Opacity* opacity = nullptr;  ///< nullptr: opaque everywhere
    std::vector<FacetPlane> planes;
    std::vector<Vec3> normals;  ///< one a vertex, or empty: flat
    std::optional<ConvexSolid> solid;
};

/// A mesh that many shapes share, in its own frame.
struct SharedMesh {
    const Mesh* mesh = nullptr;
    std::vector<FacetPlane> planes;
    bool flat = true;             ///< no normals, or none that say more than the planes
    Bounds bounds;                ///< of the vertices
    RTCSceneTy* scene = nullptr;  ///< its triangles, from the centre of `bounds`
};
/// One shape of those.
struct Instance {
    int shape = 0, mesh = 0;  ///< indices into Scene::shapes, AcceleratorTree::shared
    const Opacity* opacity = nullptr;
    double radius = 0.0;  ///< no point of it is farther from its centre, world frame
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
    Vec3 shift;            ///< of Embree's ray against the true one
    const Instance* instance = nullptr;  ///< whose triangles are being looked at
};
/// What Embree hands through to its callbacks: its own context, and behind it the query.
template <class EmbreeContext>
struct QueryContext {
    EmbreeContext embree;
    Query query;
};

/// The mesh of a shape, or nullptr.
inline const Mesh* mesh_of_geometry(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
    return mesh ? mesh->get() : nullptr;
}

/// What an Embree query found.
struct Found {
    unsigned geometry, primitive;
    unsigned instance;  ///< where the geometry is that of the instances
    float u, v;
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

    bool is_mesh(int shape) const {
        const Kind kind = places[std::size_t(shape)].kind;
        return kind == Kind::world_mesh || kind == Kind::instance;
    }
    const Mesh& mesh_of(int shape) const {
        return *mesh_of_geometry(described.shapes[std::size_t(shape)]);
    }
    /// Plane of a triangle in the world.
    FacetPlane plane_of(int shape, int primitive) const;
    FacetPlane plane_of(const Instance& instance, int primitive) const;
    /// The convex solid of that shape, or nullptr.
    const ConvexSolid* solid_of(int shape) const;
    /// That shape, if it is no mesh.
    const AnalyticShape& analytic_of(int shape) const;
    Vec3 centre_of(const Instance& instance) const;
    /// Whether the shading normal is the true one everywhere; else that of a vertex.
    bool flat(int shape) const;
    Vec3 vertex_normal(int shape, std::uint32_t vertex) const;

    const Scene& described;
    RTCDeviceTy* device = nullptr;
    RTCSceneTy* scene = nullptr;
    double scale = 1.0;  ///< of the coordinates, metres: what roundings are measured by
    Vec3 centre;         ///< of a ball around all bounded shapes
    double radius = std::numeric_limits<double>::infinity();

    // Geometry IDs are those of `meshes`; then come the bounded analytic shapes, and the instances.
    std::vector<WorldMesh> meshes;
    std::vector<AnalyticShape> analytic, planes;
    std::vector<int> analytic_shape, plane_shape;  ///< indices into Scene::shapes
    std::vector<SharedMesh> shared;
    std::unordered_map<const Mesh*, int> shared_index;  ///< into `shared`
    std::vector<Instance> instances;
    unsigned analytic_geometry() const { return unsigned(meshes.size()); }
    unsigned instance_geometry() const { return unsigned(meshes.size()) + 1; }

    enum class Kind : std::uint8_t { world_mesh, instance, analytic, plane };
    struct Place {
        Kind kind;
        int index;
    };
    std::vector<Place> places;  ///< one a shape: where it is among those

    std::vector<bool> see_through;
    const Opacity* opacity = nullptr;
    std::vector<bool> partly_there;  ///< one a shape: whether to ask `opacity`
    /// One a shape: convex, with nothing else inside, so that rays within it need not ask the tree.
    std::vector<bool> undisturbed;

private:
    void add_shape(const Shape& shape, int index);
    void add_mesh(const Shape& shape, int index);
    void share_meshes();
    void add_shared(const Mesh& mesh);
    void attach_analytic();
    void attach_instances();
    std::vector<bool> find_all_undisturbed() const;
    const Opacity* opacity_of(int shape) const {
        return partly_there[std::size_t(shape)] ? opacity : nullptr;
    }

    LaneMask leave_undisturbed(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    double start_of(const Ray& ray) const;
    void look_back(const RayLanes& rays, int k, Hit& hit) const;
    void finish_lane(const RayLanes& rays, int k, const Found& found, Hit& hit) const;
    void meet_planes(const RayLanes& rays, int k, Hit& hit) const;
};

const char* embree_isa();

/// What Embree calls. The user pointer of a mesh's geometry is its WorldMesh, all others are the
/// AcceleratorTree.
namespace embree_callbacks {
void measure_hit(const RTCFilterFunctionNArguments* args);
void measure_shadow(const RTCFilterFunctionNArguments* args);
void bound_analytic(const RTCBoundsFunctionArguments* args);
void meet_analytic(const RTCIntersectFunctionNArguments* args);
void shadow_analytic(const RTCOccludedFunctionNArguments* args);
void measure_instance_hit(const RTCFilterFunctionNArguments* args);
void measure_instance_shadow(const RTCFilterFunctionNArguments* args);
void bound_instance(const RTCBoundsFunctionArguments* args);
void meet_instance(const RTCIntersectFunctionNArguments* args);
void shadow_instance(const RTCOccludedFunctionNArguments* args);
}  // namespace embree_callbacks

}  // namespace dewbow
