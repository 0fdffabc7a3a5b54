// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shapes that are intersected in closed form, in double precision: sphere, disc, rectangle, box,
// prism, plane. A ray that starts on one of them knows it (SurfaceFrom), and since all of them are
// convex, it either meets the far side or nothing: no ray leaks through an edge.

#include <memory>

#include "dewbow/render/ray.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// Coordinates on a surface, for textures, and how the point of the world moves with them.
struct SurfaceChart {
    double u = 0.0, v = 0.0;  ///< v grows downwards
    Vec3 du, dv;              ///< metres per unit of u and v
};

class AnalyticShape {
public:
    /// True for every geometry but meshes.
    static bool holds(const Geometry& geometry);
    /// @param contact  distance in metres within which a ray that starts on another shape starts on
    /// this one too: bodies may stand on each other.
    AnalyticShape(const Shape& shape, double contact);

    /// Nearest hit with 0 < t < t_max.  @param from_here  the ray starts on this shape.
    /// Sets t and primitive (the face of a polyhedron); returns whether there is one.
    bool intersect(Vec3 origin, Vec3 direction, bool from_here, bool inward, double t_max,
                   double& t, int& primitive) const;
    /// Outward unit normal at a point of the surface.
    Vec3 normal(Vec3 world_point, int primitive) const;
    /// The surface's own coordinates at a point of it: docs/conventions.md, "Coordinates on
    /// surfaces". In [0, 1], but on planes, where they are metres. `du` vanishes at the poles of a
    /// sphere.
    SurfaceChart chart(Vec3 world_point, int primitive) const;
    bool infinite() const { return kind_ == Kind::plane; }

private:
    enum class Kind { sphere, disc, rectangle, polyhedron, plane };
    struct Face {
        Vec3 normal;  ///< outward, unit, object frame
        double distance;
        Vec3 centre, right, down;  ///< of its chart: from edge to edge, object frame
    };
    struct Polyhedron {
        std::array<Face, 6> faces{};
        int count = 0;
    };
    static Polyhedron box_of(const Box& box);
    static Polyhedron prism_of(const Prism& prism);
    SurfaceChart chart_of_sphere(Vec3 p) const;
    bool enters_at_start(double height, double slope) const;
    bool intersect_sphere(Vec3 o, Vec3 d, bool from_here, bool inward, double t_max,
                          double& t) const;
    bool intersect_flat(Vec3 o, Vec3 d, bool from_here, double t_max, double& t) const;
    bool intersect_polyhedron(Vec3 o, Vec3 d, bool from_here, bool inward, double t_max, double& t,
                              int& face) const;

    Kind kind_ = Kind::plane;
    double contact_;  ///< in the object frame
    Transform<World, Object> world_from_object_;
    double radius_ = 0.0, half_width_ = 0.0, half_height_ = 0.0;
    std::shared_ptr<const Polyhedron> polyhedron_;
};

/// Corners of a box or prism (object frame) and its outward triangles, for lights and bounds.
std::vector<std::array<Vec3, 3>> triangles_of(const Box& box);
std::vector<std::array<Vec3, 3>> triangles_of(const Prism& prism);

}  // namespace dewbow
