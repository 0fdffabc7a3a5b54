// SPDX-License-Identifier: Apache-2.0
#pragma once

// The directions in which a point sees a body: sampled alike over the solid angle that it fills.

#include "dewbow/render/caustics/caster_bounds.h"
#include "dewbow/render/caustics/spherical_rectangle.h"

namespace dewbow::caustics {

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
    /// A face of a box that is seen from outside.
    struct Face {
        int axis;      ///< of the box, perpendicular to the face
        double share;  ///< of the choices
        SphericalRectangle seen;
    };
    struct ToBox {
        OrientedBox box;
        Vec3 from;  ///< the point, from the centre, in the box's axes
        std::array<Face, 3> faces;
        int count;
        bool far;  ///< faces are small, and sampled by area

        double density(const Face& face, Vec3 direction, double distance) const;
    };
    struct ToBall {
        Vec3 axis;
        double width;  ///< 1 − cos of the half angle
    };
    static std::optional<DirectionsTo> to(const OrientedBox& box, Vec3 point);
    static std::optional<DirectionsTo> to(const Ball& ball, Vec3 point);
    static std::optional<DirectionsTo> to(const EndlessPlane& plane, Vec3 point);
    static Sample sample_of(const ToBox& to, std::array<double, 2> u);
    static Sample sample_of(const ToBall& to, std::array<double, 2> u);
    static std::optional<SquarePlace> place_in(const ToBox& to, Vec3 direction);
    static std::optional<SquarePlace> place_in(const ToBall& to, Vec3 direction);
    DirectionsTo(double solid_angle, std::variant<ToBox, ToBall> to)
        : solid_angle_(solid_angle), to_(std::move(to)) {}

    double solid_angle_;
    std::variant<ToBox, ToBall> to_;
};

}  // namespace dewbow::caustics
