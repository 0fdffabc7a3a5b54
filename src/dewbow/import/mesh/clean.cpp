// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/clean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewbow {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Coordinates beyond this are no place, and their squares leave the range of float.
constexpr double kLargestCoordinate = 1e15;
/// A triangle whose height is less than this part of its longest edge is a line: in double
/// precision its normal is rounding alone (2⁻⁵² ≈ 2e-16, and a coordinate difference loses a few
/// bits).
constexpr double kThinnest = 1e-14;

bool usable(Vec3 v) {
    return std::abs(v.x) <= kLargestCoordinate && std::abs(v.y) <= kLargestCoordinate &&
           std::abs(v.z) <= kLargestCoordinate;  // false for NaN
}

/// Twice the area times the normal; zero if the triangle is a line or a point.
Vec3 area_normal(const Mesh& mesh, const Triangle& triangle) {
    const Vec3 a = mesh.vertices[triangle[0]].v;
    const Vec3 ab = mesh.vertices[triangle[1]].v - a, ac = mesh.vertices[triangle[2]].v - a;
    const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(ac - ab, ac - ab)});
    const Vec3 normal = cross(ab, ac);
    // Below, squares of squares underflow.
    constexpr double kSmallestEdge2 = 1e-100;
    if (longest < kSmallestEdge2 || length(normal) <= kThinnest * longest) return {};
    return normal;
}

void drop_triangles(Mesh& mesh, MeshRepairs& repairs) {
    std::size_t kept = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const bool finite = std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t i) {
            return usable(mesh.vertices[i].v);
        });
        if (!finite) {
            ++repairs.bad_vertex_triangles;
        } else if (area_normal(mesh, triangle) == Vec3{}) {
            ++repairs.flat_triangles;
        } else {
            mesh.triangles[kept++] = triangle;
        }
    }
    mesh.triangles.resize(kept);
}

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Moves what each vertex i with new_index[i] != kUnused has to its new place, none of which lies
/// above its old one. Lists that are empty stay so.

template <class T>
void renumber(std::vector<T>& values, const std::vector<std::uint32_t>& new_index,
              std::size_t kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < new_index.size(); ++i)
        if (new_index[i] != kUnused) values[new_index[i]] = values[i];
    values.resize(kept);
}

void drop_unused_vertices(Mesh& mesh) {
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t i : triangle) new_index[i] = 0;
    }
    std::uint32_t kept = 0;
    for (std::uint32_t& index : new_index)
        if (index != kUnused) index = kept++;
    renumber(mesh.vertices, new_index, kept);
    renumber(mesh.normals, new_index, kept);
    for (auto& set : mesh.texcoords) renumber(set, new_index, kept);
    renumber(mesh.colours, new_index, kept);
    renumber(mesh.tangents, new_index, kept);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& i : triangle) i = new_index[i];
    }
}

bool has_direction(const Normal<Object>& normal) {
    const double squared = dot(normal.v, normal.v);
    return squared > 1e-30 && std::isfinite(squared);
}

void renew_normals(Mesh& mesh, MeshRepairs& repairs) {
    const auto bad = std::count_if(mesh.normals.begin(), mesh.normals.end(),
                                   [](const auto& normal) { return !has_direction(normal); });
    if (bad == 0) return;
    repairs.normals += std::size_t(bad);
    std::vector<Vec3> sums(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t i : triangle) sums[i] += normalised(area_normal(mesh, triangle));
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (has_direction(mesh.normals[i])) continue;
        const bool opposed =
            !has_direction({sums[i]});  // its triangles cancel: any of them will do
        mesh.normals[i].v = opposed ? Vec3{0.0, 0.0, 1.0} : normalised(sums[i]);
    }
}

}  // namespace

MeshRepairs& MeshRepairs::operator+=(const MeshRepairs& other) {
    bad_vertex_triangles += other.bad_vertex_triangles;
    flat_triangles += other.flat_triangles;
    normals += other.normals;
    return *this;
}

void MeshRepairs::report(const SourcePlace& place, Diagnostics& diagnostics) const {
    if (bad_vertex_triangles > 0) {
        diagnostics.push_back(
            {place, fmt::format("dropped {} triangles with a vertex that is not finite",
                                bad_vertex_triangles)});
    }
    if (flat_triangles > 0) {
        diagnostics.push_back(
            {place, fmt::format("dropped {} triangles without area", flat_triangles)});
    }
    if (normals > 0) {
        diagnostics.push_back(
            {place, fmt::format("renewed {} normals without direction", normals)});
    }
}

std::string MeshRepairs::sentence_of_nothing_left() const {
    if (bad_vertex_triangles == 0) return "has no triangle with an area";
    return fmt::format(
        "has no triangle that can be shown: {} with a vertex that is not finite, {} without area",
        bad_vertex_triangles, flat_triangles);
}

MeshRepairs clean(Mesh& mesh) {
    MeshRepairs repairs;
    drop_triangles(mesh, repairs);
    drop_unused_vertices(mesh);
    renew_normals(mesh, repairs);
    return repairs;
}

void add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
}

}  // namespace dewbow
