// SPDX-License-Identifier: Apache-2.0
#pragma once

// Convex bodies around casters, as lamps see them: from infinitely far, and from a point. Rays that
// enter a body are sampled alike over its silhouette: the faces of a box that a lamp sees tile what
// it sees of the box.

#include <array>
#include <optional>
#include <variant>

#include "dewbow/math/vector.h"
#include "dewbow/render/caustics/spherical_rectangle.h"
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
};
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

    /// Whether a ray meets the body, or starts in it.
    bool met_by(Vec3 origin, Vec3 direction) const;

    bool endless() const { return std::holds_alternative<EndlessPlane>(body_); }
    const Body& body() const { return body_; }
    /// A ball around it; of a plane without end an infinite one.
    Ball ball() const;
    /// Area of the surface, m².
    double surface() const;

private:
    Body body_;
};

/// The directions from a point outside of a body in which it sees the body.
class DirectionsTo {
public:
    /// Nothing if the point lies in the body, too near to it, or the body has no end.
    static std::optional<DirectionsTo> from(Vec3 point, const CasterBounds& bounds);

    /// sr.
    double solid_angle() const { return solid_angle_; }
    struct Sample {
        Vec3 direction;
        double pdf;  ///< per sr
    };
    Sample sample(std::array<double, 2> u) const;
    /// The inverse; nothing in other directions.
    std::optional<SquarePlace> place_of(Vec3 direction) const;

private:
    /// A face of a box, in the box's axes: `axis` is perpendicular to it.
    struct Face {
        int axis;
        double share;  ///< of the choices
        SphericalRectangle seen;
    };
    struct ToBox {
        OrientedBox box;
        Vec3 from;  ///< of the point, from the centre, in the box's axes
        std::array<Face, 3> faces;
        int count = 0;
        bool far = false;  ///< faces are sampled by area
    };
    struct ToBall {
        Vec3 axis;
        double width;  ///< 1 − cos of the half angle
    };
    DirectionsTo() = default;

    double solid_angle_ = 0.0;
    std::variant<ToBox, ToBall> to_;
};

}  // namespace dewbow::caustics
