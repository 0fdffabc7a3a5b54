// SPDX-License-Identifier: Apache-2.0
#pragma once

// Convex bodies around casters. Rays of one direction are sampled alike over the silhouette that a
// body shows to it: the faces of a box that are seen tile what is seen of the box.

#include <array>
#include <optional>
#include <variant>

#include "dewbow/math/vector.h"
#include "dewbow/scene/scene.h"

namespace dewbow::caustics {

/// A box of any orientation.
struct OrientedBox {
    Vec3 centre;
    std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  ///< unit, orthogonal
    Vec3 half;                                                              ///< along the axes, m

    Vec3 to_local(Vec3 direction) const {
        return {dot(direction, axes[0]), dot(direction, axes[1]), dot(direction, axes[2])};
    }
    Vec3 to_world(Vec3 local) const {
        return axes[0] * local.x + axes[1] * local.y + axes[2] * local.z;
    }
    /// m², of one of the two faces that an axis is perpendicular to.
    double face_area(int axis) const { return 4.0 * half[(axis + 1) % 3] * half[(axis + 2) % 3]; }
};
/// Where a line, given in the box's axes from its centre, enters and leaves a box.
struct Passage {
    double t_in, t_out;
    int axis_in;  ///< perpendicular to the face of entry
};
/// Nothing if it misses.
std::optional<Passage> passage(const OrientedBox& box, Vec3 origin, Vec3 direction);
/// A point of the face on the side `side` of the axis that is perpendicular to it, in the box's
/// axes from its centre; and back.   @param place  from 0 to 1 along the two axes that follow.
Vec3 point_on_face(const OrientedBox& box, std::array<double, 2> place, int axis, double side);
std::array<double, 2> place_on_face(const OrientedBox& box, Vec3 local, int axis);

struct Ball {
    Vec3 centre;
    double radius;
};
/// A plane without end: what lamps without end cannot cover alike.
struct EndlessPlane {
    Vec3 point;    ///< near to which there is something to see
    Vec3 normal;   ///< unit
    double reach;  ///< m; half of the rays from infinitely far meet the plane within sqrt(3) reach
};

/// Place in the unit square that gives a ray, and the density with which uniform numbers do.
struct SquarePlace {
    std::array<double, 2> u;
    double pdf;
};

class CasterBounds {
public:
    using Body = std::variant<OrientedBox, Ball, EndlessPlane>;
    explicit CasterBounds(Body body) : body_(std::move(body)) {}

    /// A point through which a ray along `direction` enters; `pdf` per m² perpendicular to it.
    struct Entry {
        Vec3 point;
        double pdf;
    };
    /// Nothing if the body shows no area to that direction.
    std::optional<Entry> enter(Vec3 direction, std::array<double, 2> u) const;
    /// The inverse, for the whole line; nothing if it misses.
    std::optional<SquarePlace> entry_of(Vec3 origin, Vec3 direction) const;

    struct Crossing {
        double t_in, t_out;  ///< m along the line; equal for a plane
    };
    /// Nothing if the line misses.
    std::optional<Crossing> crossing(Vec3 origin, Vec3 direction) const;

    bool endless() const { return std::holds_alternative<EndlessPlane>(body_); }
    const Body& body() const { return body_; }
    /// A box around it; of a plane without end an empty one.
    Bounds box() const;
    /// A ball around it; of a plane without end an infinite one.
    Ball ball() const;
    /// Area of the surface, m².
    double surface() const;

private:
    Body body_;
};

}  // namespace dewbow::caustics
