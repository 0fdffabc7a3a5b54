// SPDX-License-Identifier: Apache-2.0
#pragma once

// What every mesh goes through, whatever file it comes from.

#include <span>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// What clean() had to do.
struct MeshRepairs {
    std::size_t bad_vertex_triangles = 0;  ///< dropped: a corner is not finite, or beyond 1e15
    std::size_t flat_triangles = 0;        ///< dropped: no area
    std::size_t normals = 0;               ///< made anew from the triangles around them

    MeshRepairs& operator+=(const MeshRepairs& other);
    /// Adds a diagnostic for each that is not zero.
    void report(const SourcePlace& place, Diagnostics& diagnostics) const;
    /// Why no triangle is left.
    std::string sentence_of_nothing_left() const;
};

/// Drops triangles that a renderer cannot use, then vertices that no triangle uses, and gives
/// normals without direction a new one. Indices must be in range, and normals, texture coordinates,
/// colours and tangents none or as many as vertices.
MeshRepairs clean(Mesh& mesh);

/// Splits the polygon of `corners` into triangles around its first corner and adds them.
void add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners);

}  // namespace dewbow
