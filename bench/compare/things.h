// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a ray meets in a scene of caustics, in closed form and in double: planes, spheres,
// rectangles and discs, and nothing that a contestant uses. Which body a ray is in is known from
// what it crossed before.

#include <cstdint>
#include <optional>
#include <vector>

#include "clear_body.h"
#include "plain_scene.h"

namespace dewbow::bench {

/// Which bodies a ray is in: bit b is set in body b. 0: outside all of them.
using Inside = std::uint32_t;

struct Meeting {
    double distance = 0.0;     ///< along a unit direction, m
    Vec3 normal;               ///< unit; of a body outwards
    int body = -1;             ///< its number, or -1:
    double reflectance = 0.0;  ///< a receiver, or a lamp, which reflects nothing
};

class Things {
public:
    /// Throws InputError if a body has neither faces nor radius, or if there are more than 32.
    explicit Things(const PlainScene& scene);

    std::size_t bodies() const { return bodies_.size(); }
    /// The first thing along the ray; a body's boundary counts from the side on which the ray is.
    std::optional<Meeting> first(Vec3 origin, Vec3 d, const Inside& inside) const;
    /// Whether nothing stands between two points outside all bodies.
    bool sees(Vec3 from, Vec3 to) const;
    /// Whether a ray from outside all bodies leaves the scene and meets nothing.
    bool is_free(Vec3 origin, Vec3 d) const;
    /// Of the bodies that a ray is in, that whose index counts; -1: it is in none.
    int medium(const Inside& inside) const;

    /// Whether a point that is on no boundary lies in a body.
    bool contains(std::size_t body, Vec3 p) const;

    struct Ball {
        Vec3 centre;
        double radius = 0.0;
    };
    Ball around_bodies() const;
    Ball around_all() const;

private:
    struct Triangle {
        Vec3 corner, normal, to_u, to_v;  ///< barycentric: dot(p - corner, to_u), …
    };
    struct Body {
        std::optional<PlainSphere> sphere;
        std::optional<ConvexFaces> faces;  ///< of a convex body,
        std::vector<Triangle> triangles;   ///< of another one
        int priority = 0;
        Ball around;
    };
    struct Flat {
        PlainLamp form;
        double reflectance = 0.0;
    };
    static Body body_of(const PlainBody& plain);
    static std::optional<ConvexFaces::Crossing> crossing(const Body& body, Vec3 origin, Vec3 d,
                                                         bool inside);

    std::vector<Body> bodies_;
    std::vector<Flat> flats_;
    Ball around_bodies_, around_all_;
};

}  // namespace dewbow::bench
