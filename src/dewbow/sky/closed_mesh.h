// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inside of a closed surface of triangles as a place for rain: all that a line meets of it, and
// the way that light has gone in it.
//
// A line and the direction towards the light span a plane, which cuts the mesh in polygons. A
// vertex lies on one side of that plane or on the other, never in it, and an edge is cut at one
// place for all its triangles: so the polygons are closed exactly, whatever the line meets (edges,
// vertices, facets along it), and what lies inside is known by counting: odd or even.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dewbow/sky/rain_region.h"

namespace dewbow {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// What keeps a surface from having an inside: edges of an odd number of triangles.
struct OpenEdges {
    std::size_t count;
    Vec3 from, to;  ///< the first of them
};

/// Which way the triangles face does not matter. Where a surface goes through itself, what lies
/// behind two of its sheets is outside. World frame, metres.
class ClosedMesh {
public:
    /// Vertices at one place count as one. The surface must be closed: see open_edges.
    ClosedMesh(const std::vector<Vec3>& vertices, std::vector<TriangleIndices> triangles);
    /// Nothing where the surface is closed.
    static std::optional<OpenEdges> open_edges(const std::vector<Vec3>& vertices,
                                               std::vector<TriangleIndices> triangles);

    /// Appends the stretches of the first `length` m (may be infinite) of a line that lie inside,
    /// in order.   Cost: the triangles near the line, by a tree.
    void cut(Point<World> origin, Dir<World> direction, double length,
             std::vector<LineInterval>& inside) const;

    /// As ConvexRegion's: exact but for rounding, where the surface does not go through itself.
    /// Cost: the triangles near the plane of both directions, by a tree.
    void lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                         Dir<World> towards, std::vector<LengthPiece>& pieces) const;

private:
    struct Node {
        Vec3 centre, half;           ///< of the box around all its triangles
        std::uint32_t first, count;  ///< triangles of a leaf; count 0: not a leaf
        std::uint32_t right;         ///< the second child; the first one follows the node
    };
    void build(std::uint32_t first, std::uint32_t count);
    /// Calls `visit(triangle)` for all triangles in boxes that `may_meet(centre, half)`.
    void visit_triangles(const auto& may_meet, const auto& visit) const;

    struct Slice;
    struct Segment;
    void cut_by_plane(const Slice& slice, const auto& may_meet, std::vector<Segment>& found) const;
    static std::vector<Segment> upper_part(const std::vector<Segment>& polygon, LineInterval on);
    /// Where the whole line, both ways, goes through the surface, in order: an even number.
    std::vector<double> crossings(Point<World> origin, Dir<World> direction) const;
    void lengths_along(Point<World> origin, Dir<World> direction, LineInterval on, bool ahead,
                       std::vector<LengthPiece>& pieces) const;

    std::vector<Vec3> vertices_;
    std::vector<TriangleIndices> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace dewbow
