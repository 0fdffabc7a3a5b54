// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where rain falls: convex regions of space, cut by lines, and the way that light has gone in them
// before it comes to a point of a line. All in the world frame, metres, double precision.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/math/transform.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// The points p with normal · p <= offset.
struct HalfSpace {
    Vec3 normal;          ///< unit, out of what is meant
    double offset = 0.0;  ///< m
};

/// A stretch of a line, by the distance from its origin in m; `end` may be infinite.
struct LineInterval {
    double begin = 0.0, end = 0.0;
};

/// A length that changes linearly along a stretch of a line: `length` at its begin, and
/// `length + slope (s - begin)` at distance s. An infinite length has slope 0.
struct LengthPiece {
    double begin = 0.0, end = 0.0;  ///< m
    double length = 0.0;            ///< m, >= 0
    double slope = 0.0;             ///< m per m
};

/// The points that all of some half-spaces have in common; all of space where there are none.
class ConvexRegion {
public:
    /// All of space.
    ConvexRegion() = default;
    explicit ConvexRegion(std::vector<HalfSpace> half_spaces);

    static ConvexRegion everywhere() { return {}; }
    /// Between two heights, without end to the sides.
    static ConvexRegion layer(Length bottom, Length top);
    /// The box around the origin of its frame that reaches `half` (m, each > 0) to both sides.
    static ConvexRegion box(const Transform<World, Object>& world_from_box, Vec3 half);
    /// An upright sheet of `thickness` between two heights, over the line from `from` to `to`
    /// (whose heights do not matter).
    static ConvexRegion curtain(Point<World> from, Point<World> to, Length thickness, Length bottom,
                                Length top);

    /// What of it lies above a height.
    ConvexRegion above(double height_m) const;

    std::span<const HalfSpace> half_spaces() const { return half_spaces_; }
    bool contains(Point<World> point) const;
    /// The distance between the two parallel faces that lie closest together; nothing where no two
    /// half-spaces look in opposite directions.
    std::optional<Length> thickness() const;

    /// What lies inside of the first `length` m (may be infinite) of a line; nothing where it
    /// misses or only touches. `direction`: unit.
    std::optional<LineInterval> cut(Point<World> origin, Dir<World> direction, double length) const;

    /// How far it is, within the region, from the points of a line (inside or outside) towards
    /// `towards` (unit): as a function of the distance along the line it is linear by pieces.
    /// Appends the pieces, which cover `on` without gap, in order; they are exact but for rounding.
    /// Where the way has no end the length is infinite.
    void lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                         Dir<World> towards, std::vector<LengthPiece>& pieces) const;

private:
    std::vector<HalfSpace> half_spaces_;
};

}  // namespace dewbow
