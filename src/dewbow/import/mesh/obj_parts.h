// SPDX-License-Identifier: Apache-2.0
#pragma once

// From the faces of an OBJ file, which name place, texture and normal apart, to meshes.

#include <limits>

#include "dewbow/import/mesh/obj.h"

namespace dewbow::obj {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A corner of a face as the file gives it: indices into the pool.
struct Corner {
    std::uint32_t vertex = 0, texcoord = kNone, normal = kNone;
    bool operator==(const Corner&) const = default;
};

/// All that the faces refer to.
struct Pool {
    std::vector<Point<Object>> vertices;
    std::vector<std::array<float, 4>> colours;    ///< one a vertex, or empty
    std::vector<std::array<float, 2>> texcoords;  ///< v downwards
    std::vector<Normal<Object>> normals;
};

struct Faces {
    std::string name, material;
    std::size_t material_line = 0;
    std::vector<Corner> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of corners
};

/// The same with those of one material that share a vertex (of `vertex_count`) put together.
std::vector<Faces> joined_where_they_touch(std::vector<Faces> faces, std::size_t vertex_count);

/// Corners that are alike become one vertex, numbered in the order of first use.
ObjPart assemble(const Faces& faces, const Pool& pool, const std::string& file,
                 Diagnostics& diagnostics);

}  // namespace dewbow::obj
