// SPDX-License-Identifier: Apache-2.0
#pragma once

// What there is to see, each in its own frame. Closed shapes have their normals outwards. All but
// the mesh are intersected in closed form in double precision.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "dewbow/math/transform.h"

namespace dewbow {

/// Triangles that share vertices. Front faces are counter-clockwise.
struct Mesh {
    std::string name;
    std::vector<Point<Object>> vertices;
    /// One a vertex, or empty: flat facets. Not necessarily unit length.
    std::vector<Normal<Object>> normals;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    // For textures and normal maps: one a vertex, or empty.
    std::array<std::vector<std::array<float, 2>>, 2> texcoords;  ///< v grows downwards
    std::vector<std::array<float, 4>> colours;                   ///< linear sRGB and alpha
    /// Along growing u, in .xyz; .w = ±1: the bitangent is w (normal × tangent).
    std::vector<std::array<float, 4>> tangents;
};

/// Around the origin.
struct Sphere {
    Length radius;
};
/// In the plane z = 0 around the origin, normal +z.
struct Disc {
    Length radius;
};
/// In the plane z = 0 around the origin, normal +z.
struct Rectangle {
    Length width, height;  ///< along x and y
};
/// Around the origin.
struct Box {
    Length width, height, depth;  ///< along x, y, z
};
/// A triangular prism along z: an isosceles cross-section in the xy plane, its apex at the top
/// (+y), its two sides from the apex of length `side`, its centroid at the origin.
struct Prism {
    Angle apex;
    Length side;
    Length length;  ///< along z
};
/// The plane z = 0 without end, normal +z.
struct Plane {};

using Geometry =
    std::variant<std::shared_ptr<const Mesh>, Sphere, Disc, Rectangle, Box, Prism, Plane>;

struct Shape {
    std::string name;
    Geometry geometry;
    Transform<World, Object> world_from_object;
    int material = 0;  ///< index into Scene::materials
};

}  // namespace dewbow
