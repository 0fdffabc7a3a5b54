// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/obj_parts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace dewbow::obj {
namespace {

/// Sets that are joined one by one; the first member stands for its set.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t first_of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = first_of(a), b = first_of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

void append(Faces& to, const Faces& from) {
    const auto first = std::uint32_t(to.corners.size());
    to.corners.insert(to.corners.end(), from.corners.begin(), from.corners.end());
    for (auto triangle : from.triangles) {
        for (std::uint32_t& corner : triangle) corner += first;
        to.triangles.push_back(triangle);
    }
}

struct CornerHash {
    std::size_t operator()(const Corner& c) const {
        const std::uint64_t low = (std::uint64_t{c.vertex} << 32) | c.normal;
        const std::uint64_t hash = (low ^ (std::uint64_t{c.texcoord} * 0xff51afd7ed558ccdu)) *
                                   0x9e3779b97f4a7c15u;  // golden ratio · 2⁶⁴
        return hash ^ (hash >> 32);
    }
};

/// How many of the corners have what `index` names.
std::size_t count_with(const Faces& faces, std::uint32_t Corner::*index) {
    return std::size_t(std::count_if(faces.corners.begin(), faces.corners.end(),
                                     [&](const Corner& corner) { return corner.*index != kNone; }));
}

}  // namespace

std::vector<Faces> joined_where_they_touch(std::vector<Faces> faces, std::size_t vertex_count) {
    DisjointSets sets(faces.size());
    std::map<std::string, std::vector<std::size_t>> by_material;
    for (std::size_t i = 0; i < faces.size(); ++i) by_material[faces[i].material].push_back(i);
    for (const auto& [material, members] : by_material) {
        if (members.size() < 2) continue;
        std::vector<std::uint32_t> owner(vertex_count, kNone);
        for (const std::size_t i : members) {
            for (const Corner& corner : faces[i].corners) {
                std::uint32_t& first = owner[corner.vertex];
                if (first == kNone) first = std::uint32_t(i);
                sets.join(first, i);
            }
        }
    }
    std::vector<Faces> result;
    std::map<std::size_t, std::size_t> place;  // of each set in `result`
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto [found, is_new] = place.try_emplace(sets.first_of(i), result.size());
        if (is_new) {
            result.push_back(std::move(faces[i]));
        } else {
            append(result[found->second], faces[i]);
        }
    }
    return result;
}

ObjPart assemble(const Faces& faces, const Pool& pool, const std::string& file,
                 Diagnostics& diagnostics) {
    const std::size_t normals = count_with(faces, &Corner::normal);
    const bool with_normals = normals == faces.corners.size();
    if (normals > 0 && !with_normals)
        diagnostics.push_back({{file, 0, 0, faces.name},
                               "only some corners have normals: none are used, facets are flat"});
    const std::size_t texcoords = count_with(faces, &Corner::texcoord);
    if (texcoords > 0 && texcoords < faces.corners.size())
        diagnostics.push_back({{file, 0, 0, faces.name},
                               "only some corners have texture coordinates: the others are at the "
                               "picture's corner"});

    ObjPart part{faces.name, faces.material, faces.material_line, {}};
    Mesh& mesh = part.mesh;
    mesh.triangles = faces.triangles;
    std::unordered_map<Corner, std::uint32_t, CornerHash> index_of;
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& index : triangle) {
            Corner corner = faces.corners[index];
            if (!with_normals) corner.normal = kNone;
            const auto [found, is_new] =
                index_of.try_emplace(corner, std::uint32_t(mesh.vertices.size()));
            index = found->second;
            if (!is_new) continue;
            mesh.vertices.push_back(pool.vertices[corner.vertex]);
            if (!pool.colours.empty()) mesh.colours.push_back(pool.colours[corner.vertex]);
            if (with_normals) mesh.normals.push_back(pool.normals[corner.normal]);
            if (texcoords > 0)
                mesh.texcoords[0].push_back(corner.texcoord == kNone
                                                ? std::array{0.0f, 0.0f}
                                                : pool.texcoords[corner.texcoord]);
        }
    }
    return part;
}

}  // namespace dewbow::obj
