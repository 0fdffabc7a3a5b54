// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/casters.h"

#include <algorithm>
#include <cmath>

#include "dewbow/render/caustics/caster_tree.h"
#include "dewbow/render/surface/scattering_surface.h"

namespace dewbow::caustics {

namespace {

/// Bodies are wider than their shapes by this share of the largest coordinate: Embree decides in
/// single precision which triangle a ray meets.
constexpr double kMargin = 1e-7;
/// Axes agree to this to be orthogonal: rounding of rotations.
constexpr double kOrthogonal = 1e-9;
/// Meshes are grouped triangle by triangle while all of them together have no more: a second.
constexpr std::size_t kMostTriangles = 2'000'000;
/// Groups at most, beside planes without end; fewer where there are many lamps, since each pair
/// takes time and memory.
constexpr std::size_t kMostGroups = 1 << 14, kLeastGroups = 64, kMostPairs = 1'000'000;

const Mesh* mesh_of(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
    return mesh ? mesh->get() : nullptr;
}

double largest_coordinate(const Bounds& box) {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(box.low[axis]), std::abs(box.high[axis])});
    return largest;
}

OrientedBox aligned_box(const Bounds& box) {
    OrientedBox result;
    result.centre = box.centre();
    result.half = 0.5 * (box.high - box.low);
    return result;
}

/// The box around a shape in its own frame, unless it is none in the world.
std::optional<OrientedBox> own_box(const Shape& shape) {
    const Bounds own = bounds_of(Shape{{}, shape.geometry, {}, 0});
    if (own.empty()) return std::nullopt;
    const Affine& world = shape.world_from_object.affine();
    OrientedBox box;
    box.centre = world.apply(own.centre());
    std::array<double, 3> scale;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 unit{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
        const Vec3 image = world.apply_linear(unit);
        scale[std::size_t(axis)] = length(image);
        box.axes[std::size_t(axis)] = normalised(image);
    }
    const auto apart = [&](std::size_t a, std::size_t b) {
        return std::abs(dot(box.axes[a], box.axes[b]));
    };
    if (std::max({apart(0, 1), apart(1, 2), apart(2, 0)}) > kOrthogonal) return std::nullopt;
    const Vec3 half = 0.5 * (own.high - own.low);
    box.half = {half.x * scale[0], half.y * scale[1], half.z * scale[2]};
    return box;
}

/// The tightest body around one shape.
CasterBounds body_around(const Shape& shape, const Bounds& box) {
    const double margin = kMargin * largest_coordinate(box);
    const Vec3 margins{margin, margin, margin};
    OrientedBox aligned = aligned_box(box);
    aligned.half += margins;
    CasterBounds best{aligned};
    std::optional<OrientedBox> own = own_box(shape);
    if (!own) return best;
    const double most = std::max({own->half.x, own->half.y, own->half.z});
    const double least = std::min({own->half.x, own->half.y, own->half.z});
    if (std::holds_alternative<Sphere>(shape.geometry) && most - least <= kOrthogonal * most)
        return CasterBounds{Ball{own->centre, most + margin}};
    own->half += margins;
    const CasterBounds turned{*own};
    return turned.surface() < best.surface() ? turned : best;
}

/// Boxes of casters' parts, and whose they are.
struct Parts {
    std::vector<Bounds> boxes;
    std::vector<int> shape;
};

void add_triangles(const Shape& shape, const Mesh& mesh, int index, Parts& parts) {
    for (const auto& triangle : mesh.triangles) {
        Bounds box;
        for (const std::uint32_t corner : triangle)
            box.add(shape.world_from_object(mesh.vertices[corner]).v);
        parts.boxes.push_back(box);
        parts.shape.push_back(index);
    }
}

/// @param boxes  of all shapes of the scene.
EndlessPlane plane_of(const Shape& shape, const Scene& scene, const std::vector<Bounds>& boxes) {
    const Vec3 normal = shape.world_from_object(Normal<Object>{{0, 0, 1}}).v;
    Bounds seen;
    seen.add(scene.camera.world_from_camera(Point<Camera>{}).v);
    for (const Bounds& box : boxes)
        if (!box.empty()) seen.add(box.low), seen.add(box.high);
    const Vec3 on_plane = shape.world_from_object(Point<Object>{}).v;
    const double height = dot(seen.centre() - on_plane, normal);
    const double reach = seen.radius() + std::abs(height);
    return {seen.centre() - normal * height, normal, reach > 0.0 ? reach : 1.0};
}

std::vector<int> find_casters(const Scene& scene, const std::vector<bool>& see_through) {
    std::vector<int> casters;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const auto material = std::size_t(scene.shapes[i].material);
        if (!see_through[i] && is_caster(scene, scene.materials[material]))
            casters.push_back(int(i));
    }
    return casters;
}

/// Triangles of meshes, and other shapes but planes whole.
Parts parts_of(const Scene& scene, const std::vector<int>& casters,
               const std::vector<Bounds>& boxes) {
    std::size_t triangles = 0;
    for (const int i : casters)
        if (const Mesh* mesh = mesh_of(scene.shapes[std::size_t(i)]))
            triangles += mesh->triangles.size();
    Parts parts;
    for (const int i : casters) {
        const Shape& shape = scene.shapes[std::size_t(i)];
        const Bounds& box = boxes[std::size_t(i)];
        if (const Mesh* mesh = mesh_of(shape); mesh && triangles <= kMostTriangles) {
            add_triangles(shape, *mesh, i, parts);
        } else if (!box.empty()) {
            parts.boxes.push_back(box);
            parts.shape.push_back(i);
        }
    }
    return parts;
}

/// The tightest body around a group: around all of one shape, or aligned with the axes.
CasterBounds body_around(const BoxGroup& group, const Parts& parts, const Scene& scene,
                         const std::vector<Bounds>& boxes) {
    const auto& members = group.members;
    const int first = parts.shape[members[0]];
    const bool alone = std::all_of(members.begin(), members.end(),
                                   [&](std::uint32_t part) { return parts.shape[part] == first; });
    const Shape& shape = scene.shapes[std::size_t(first)];
    const Mesh* mesh = mesh_of(shape);
    // A mesh may have been parted; one taken whole has too many vertices to look at again.
    if (alone && (!mesh || members.size() == mesh->triangles.size()))
        return body_around(shape, boxes[std::size_t(first)]);
    OrientedBox box = aligned_box(group.bounds);
    const double margin = kMargin * largest_coordinate(group.bounds);
    box.half += Vec3{margin, margin, margin};
    return CasterBounds{box};
}

std::size_t most_groups(const Scene& scene) {
    std::size_t lamps = scene.lights.size() + 1;
    for (const Shape& shape : scene.shapes)
        lamps += scene.materials[std::size_t(shape.material)].gives_light();
    return std::clamp(kMostPairs / lamps, kLeastGroups, kMostGroups);
}

}  // namespace

bool is_caster(const Scene& scene, const Material& material) {
    if (const auto* mix = std::get_if<Mix>(&material.surface))
        return is_caster(scene, scene.materials[std::size_t(mix->first)]) ||
               is_caster(scene, scene.materials[std::size_t(mix->second)]);
    return !ScatteringSurface::holds(material) && !std::holds_alternative<Black>(material.surface);
}

Casters::Casters(const Scene& scene, const std::vector<bool>& see_through) {
    const std::vector<int> casters = find_casters(scene, see_through);
    if (casters.empty()) return;
    const std::vector<Bounds> boxes = bounds_of_shapes(scene);
    for (const int i : casters) {
        const Shape& shape = scene.shapes[std::size_t(i)];
        if (std::holds_alternative<Plane>(shape.geometry))
            groups_.emplace_back(plane_of(shape, scene, boxes));
    }
    const Parts parts = parts_of(scene, casters, boxes);
    for (const BoxGroup& group : group_boxes(parts.boxes, most_groups(scene)))
        groups_.push_back(body_around(group, parts, scene, boxes));
}

}  // namespace dewbow::caustics
