// SPDX-License-Identifier: Apache-2.0
#pragma once

// A shape that gives off light, in parts that are chosen and sampled by themselves: the triangles
// of a mesh, the faces of a rectangle, box or prism; a disc or a sphere is one part.

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "dewbow/math/distribution.h"
#include "dewbow/render/analytic_shape.h"
#include "dewbow/render/glow.h"
#include "dewbow/render/light_bounds.h"
#include "dewbow/render/ray.h"

namespace dewbow {

class GlowingShape {
public:
    /// The material of shape `shape` gives light. Throws InputError for a plane without end.
    GlowingShape(const Scene& scene, int shape);

    int parts() const { return int(bounds_.size()); }
    /// Intensity 0 for a part without area.
    const LightBounds& bounds(int part) const { return bounds_[std::size_t(part)]; }

    struct Sample {
        Vec3 position, direction;
        double distance;
        double pdf;         ///< per steradian
        int primitive = 0;  ///< as of a hit there
        double u = 0.0, v = 0.0;
    };
    /// A direction from `from` to a point of the part: nothing if that shows its dark side.
    std::optional<Sample> sample(int part, Vec3 from, std::array<double, 2> u) const;
    /// The part that `hit` on this shape, at `point`, lies in.
    int part_of(const Hit& hit, Vec3 point) const;
    /// Density per steradian with which sample() takes, from `from`, the direction to `hit`.
    double pdf(int part, Vec3 from, Vec3 direction, const Hit& hit) const;

    const Glow& glow() const { return glow_; }
    /// Whether a ray along `direction` that meets the surface where its outward normal is `normal`
    /// sees it glow.
    bool shines(Vec3 direction, Vec3 normal) const {
        return glow_.two_sided() || dot(direction, normal) < 0.0;
    }
    /// What textures are looked up by where `sample` meets the surface.
    SurfaceCoordinates coordinates(const Sample& sample) const;

    struct SurfacePoint {
        Vec3 position, normal;
        double pdf_area;  ///< per m²
        int primitive = 0;
        double u = 0.0, v = 0.0;
    };
    /// A point of a part by uniform numbers: all alike, but more where a picture is brighter.
    SurfacePoint point_of(int part, std::array<double, 2> u) const;
    /// The numbers by which point_of() gives `point`.
    std::array<double, 2> place_of(int part, Vec3 point) const;
    /// Density of point_of(), per area of the world.
    double pdf_area(int part, Vec3 point) const;
    SurfaceCoordinates coordinates(const SurfacePoint& point) const {
        return coordinates(point.position, point.primitive, point.u, point.v);
    }
    /// Outward unit normal at a point of a primitive, as a hit names it.
    Vec3 normal_at(Vec3 point, int primitive) const;
    struct WorldBall {
        Vec3 centre;
        double radius;
    };
    /// If the shape is a ball in the world.
    std::optional<WorldBall> ball() const;
    /// Index into Scene::shapes.
    int shape() const { return shape_; }

private:
    /// A flat face: a triangle, or a parallelogram that the two edges span.
    struct Face {
        Vec3 corner, edge_u, edge_v;
        Vec3 normal{0.0, 0.0, 1.0};  ///< unit, outward
        double area = 0.0;
        bool triangle = false;
        int primitive = 0;
        int picture = -1;  ///< index into pictures_, −1: all of it is sampled alike

        /// Where `point` lies along the edges: both 0 at the corner, 1 at the edges' ends.
        std::array<double, 2> place_of(Vec3 point) const;
    };
    struct FlatDisc {
        Vec3 normal;
        double radius;  ///< in the object's frame
        double area;
    };
    struct Ball {
        Vec3 centre;
        double object_radius;
        std::optional<double> radius;  ///< in the world, if it is a sphere there
    };
    void add_faces(const Geometry& geometry);
    void add_face(Vec3 corner, Vec3 edge_u, Vec3 edge_v, bool triangle);
    void add_faces(const Mesh& mesh);
    void add_faces(const Rectangle& rectangle);
    void add_faces(const Box& box);
    void add_faces(const Prism& prism);
    void name_faces(int primitives);
    void add_disc(const Disc& disc, const Bounds& box);
    void add_ball(const Sphere& sphere, const Bounds& box);
    void look_at_glow(int part);
    double mean_brightness(int part) const;
    Distribution2D picture_of(int part) const;

    SurfacePoint point_at(int part, std::array<double, 2> place) const;
    double pdf_area_of_ball(const Ball& ball, Vec3 point) const;
    SurfaceCoordinates coordinates(Vec3 position, int primitive, double u, double v) const;

    int shape_;
    Glow glow_;
    Transform<World, Object> world_from_object_;
    std::shared_ptr<const Mesh> mesh_;  ///< one of these two
    std::optional<AnalyticShape> analytic_;
    std::variant<std::vector<Face>, FlatDisc, Ball> surface_;
    std::vector<Distribution2D> pictures_;
    std::vector<LightBounds> bounds_;  ///< one a part
};

}  // namespace dewbow
