// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where a rain of a scene is, ready for lines.

#include <memory>
#include <variant>
#include <vector>

#include "dewbow/scene/rain.h"
#include "dewbow/sky/closed_mesh.h"

namespace dewbow {

/// Immutable; cheap to copy.
class RainInside {
public:
    /// Of a rain that `validate` has let pass.
    explicit RainInside(const Rain& rain);

    /// Appends the stretches of the first `length` m (may be infinite) of a line that lie inside,
    /// in order.
    void cut(Point<World> origin, Dir<World> direction, double length,
             std::vector<LineInterval>& inside) const;
    /// How much of the first `length` m lies inside, in m.
    double length_inside(Point<World> origin, Dir<World> direction, double length) const;
    /// The way towards `towards` from the points of `on` of a line: see ConvexRegion.
    void lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                         Dir<World> towards, std::vector<LengthPiece>& pieces) const;

    /// The same, of the way to `towards` (downwards) as far as the plane y = `height_m`, above
    /// which `on` lies.
    void lengths_down_to(double height_m, Point<World> origin, Dir<World> direction,
                         LineInterval on, Dir<World> towards,
                         std::vector<LengthPiece>& pieces) const;

private:
    std::variant<ConvexRegion, std::shared_ptr<const ClosedMesh>> inside_;
};

/// A mesh's triangles in the world.
struct WorldTriangles {
    std::vector<Vec3> vertices;
    std::vector<TriangleIndices> triangles;
};
WorldTriangles world_triangles(const MeshRegion& region);

}  // namespace dewbow
