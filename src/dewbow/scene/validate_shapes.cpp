// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "dewbow/scene/checks.h"

namespace dewbow::checks {
namespace {

struct CheckGeometry {
    const std::string& who;

    void operator()(const std::shared_ptr<const Mesh>& mesh) const { check_mesh(who, mesh); }
    void operator()(const Sphere& s) const { check_positive(who, "radius", s.radius.to(unit::m)); }
    void operator()(const Disc& s) const { check_positive(who, "radius", s.radius.to(unit::m)); }
    void operator()(const Rectangle& s) const {
        check_positive(who, "width", s.width.to(unit::m));
        check_positive(who, "height", s.height.to(unit::m));
    }
    void operator()(const Box& s) const {
        check_positive(who, "width", s.width.to(unit::m));
        check_positive(who, "height", s.height.to(unit::m));
        check_positive(who, "depth", s.depth.to(unit::m));
    }
    void operator()(const Prism& s) const {
        const double apex_deg = s.apex.to(unit::deg);
        if (!(apex_deg > 0.0 && apex_deg < 180.0)) {
            fail(who, fmt::format("apex is {} deg; it must be between 0 and 180 deg", apex_deg));
        }
        check_positive(who, "side", s.side.to(unit::m));
        check_positive(who, "length", s.length.to(unit::m));
    }
    void operator()(const Plane&) const {}
};

}  // namespace

void check_mesh(const std::string& who, const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh) fail(who, "its mesh is missing");
    if (mesh->triangles.empty()) fail(who, "its mesh has no triangle");
    if (!mesh->normals.empty() && mesh->normals.size() != mesh->vertices.size()) {
        fail(who, fmt::format("its mesh has {} normals for {} vertices", mesh->normals.size(),
                              mesh->vertices.size()));
    }
    for (const Point<Object>& vertex : mesh->vertices) check_finite(who, "a vertex", vertex.v);
    for (const Normal<Object>& normal : mesh->normals) {
        check_finite(who, "a normal", normal.v);
        if (normal.v == Vec3{}) fail(who, "a normal has no direction");
    }
    for (const auto& triangle : mesh->triangles) {
        const std::uint32_t largest = std::max({triangle[0], triangle[1], triangle[2]});
        if (largest < mesh->vertices.size()) continue;
        fail(who, fmt::format("a triangle uses vertex {} of {}", largest, mesh->vertices.size()));
    }
}

void check_shapes(const Scene& scene) {
    std::unordered_set<const Mesh*> checked;  // meshes may stand in many places
    for (const Shape& shape : scene.shapes) {
        const std::string who = fmt::format("shape \"{}\"", shape.name);
        check_index(who, "its material", shape.material, scene.materials.size());
        check_affine(who, shape.world_from_object.affine());
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
        if (!mesh || checked.insert(mesh->get()).second)
            std::visit(CheckGeometry{who}, shape.geometry);
    }
}

}  // namespace dewbow::checks
