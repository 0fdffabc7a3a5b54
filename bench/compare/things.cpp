// SPDX-License-Identifier: Apache-2.0
#include "things.h"

#include <cmath>
#include <limits>

#include "dewbow/base/error.h"
#include "dewbow/scene/scene.h"

namespace dewbow::bench {
namespace {

/// Nothing is met nearer than this: where a ray begins on a flat thing it does not meet it again.
/// Scenes are a metre large, and double is good to 1e-16 of that.
constexpr double kNearest_m = 1e-10;

std::optional<ConvexFaces::Crossing> crossing_of_sphere(const PlainSphere& sphere, Vec3 origin,
                                                        Vec3 d, bool inside) {
    const Vec3 from_centre = origin - sphere.centre;
    const double middle = -dot(from_centre, d);
    const Vec3 nearest = from_centre + d * middle;
    const double half2 = sphere.radius * sphere.radius - dot(nearest, nearest);
    if (half2 <= 0.0) return std::nullopt;
    const double distance = middle + (inside ? std::sqrt(half2) : -std::sqrt(half2));
    // From outside the nearer crossing lies ahead of whoever has not just left it.
    if (distance <= (inside ? 0.0 : kNearest_m)) return std::nullopt;
    return ConvexFaces::Crossing{distance, normalised(from_centre + d * distance)};
}

Bounds bounds_of(const PlainBody& body) {
    Bounds bounds;
    for (const Vec3 vertex : body.vertices) bounds.add(vertex);
    if (!body.sphere) return bounds;
    const Vec3 r{body.sphere->radius, body.sphere->radius, body.sphere->radius};
    bounds.add(body.sphere->centre - r);
    bounds.add(body.sphere->centre + r);
    return bounds;
}

bool misses(Vec3 centre, double radius, Vec3 origin, Vec3 d) {
    const Vec3 from_centre = origin - centre;
    const double along = dot(from_centre, d);
    const double beyond2 = dot(from_centre, from_centre) - radius * radius;
    return beyond2 > 0.0 && (along > 0.0 || along * along < beyond2);
}

void add_all(Bounds& bounds, const PlainLamp& form) {
    for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0})
            bounds.add(form.centre + form.half_u * u + form.half_v * v);
}

}  // namespace

Things::Body Things::body_of(const PlainBody& plain) {
    /// Rounding must not cut off a corner.
    constexpr double kWider = 1.0 + 1e-9;
    Body body;
    body.sphere = plain.sphere;
    body.priority = plain.priority;
    const Bounds bounds = bounds_of(plain);
    body.around = {bounds.centre(), bounds.radius() * kWider};
    if (body.sphere) return body;
    if (plain.triangles.empty())
        throw InputError("the body '" + plain.name + "' has neither faces nor radius");
    try {
        body.faces.emplace(plain);
        return body;
    } catch (const InputError&) {
        // Not convex: its triangles are looked at one by one.
    }
    for (const auto& t : plain.triangles) {
        const Vec3 a = plain.vertices[t[0]];
        const Vec3 u = plain.vertices[t[1]] - a, v = plain.vertices[t[2]] - a;
        const Vec3 area = cross(u, v);
        const double area2 = dot(area, area);
        if (area2 == 0.0) continue;
        body.triangles.push_back(
            {a, normalised(area), cross(v, area) / area2, cross(area, u) / area2});
    }
    return body;
}

Things::Things(const PlainScene& scene) {
    if (scene.bodies.size() > 32) throw InputError("there are more than 32 bodies");
    Bounds bounds;
    for (const PlainBody& plain : scene.bodies) {
        bodies_.push_back(body_of(plain));
        const Bounds of_body = bounds_of(plain);
        bounds.add(of_body.low);
        bounds.add(of_body.high);
    }
    around_bodies_ = {bounds.centre(), bounds.radius()};
    for (const PlainReceiver& r : scene.receivers)
        flats_.push_back(
            {{r.name, LampShape::rectangle, r.centre, r.normal, r.half_u, r.half_v, nullptr, {}},
             r.reflectance});
    for (const PlainLamp& lamp : scene.lamps) flats_.push_back({lamp, 0.0});
    for (const Flat& flat : flats_) add_all(bounds, flat.form);
    around_all_ = {bounds.centre(), bounds.radius()};
}

std::optional<ConvexFaces::Crossing> Things::crossing(const Body& body, Vec3 origin, Vec3 d,
                                                      bool inside) {
    if (body.sphere) return crossing_of_sphere(*body.sphere, origin, d, inside);
    if (!inside && misses(body.around.centre, body.around.radius, origin, d)) return std::nullopt;
    if (body.faces) {
        if (inside) return body.faces->exit(origin, d);
        return body.faces->entry(origin, d);
    }
    std::optional<ConvexFaces::Crossing> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : body.triangles) {
        const double rate = dot(triangle.normal, d);
        if (inside ? rate <= 0.0 : rate >= 0.0) continue;
        const double distance = dot(triangle.corner - origin, triangle.normal) / rate;
        if (!(distance > 0.0 && distance < nearest)) continue;
        const Vec3 p = origin + d * distance - triangle.corner;
        const double u = dot(p, triangle.to_u), v = dot(p, triangle.to_v);
        if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
        nearest = distance;
        best = ConvexFaces::Crossing{distance, triangle.normal};
    }
    return best;
}

std::optional<Meeting> Things::first(Vec3 origin, Vec3 d, const Inside& inside) const {
    std::optional<Meeting> first;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (const auto met = crossing(bodies_[b], origin, d, (inside >> b & 1u) != 0);
            met && met->distance < nearest) {
            nearest = met->distance;
            first = Meeting{met->distance, met->normal, int(b), 0.0};
        }
    for (const Flat& flat : flats_)
        if (const auto distance = distance_to(flat.form, origin, d);
            distance && *distance > kNearest_m && *distance < nearest) {
            nearest = *distance;
            first = Meeting{*distance, flat.form.normal, -1, flat.reflectance};
        }
    return first;
}

bool Things::is_free(Vec3 origin, Vec3 d) const { return !first(origin, d, 0); }

bool Things::sees(Vec3 from, Vec3 to) const {
    const double distance = length(to - from);
    const auto met = first(from, (to - from) / distance, 0);
    return !met || met->distance > distance - kNearest_m;
}

int Things::medium(const Inside& inside) const {
    int medium = -1;
    for (int b = 0; b < int(bodies_.size()); ++b)
        if ((inside >> b & 1u) != 0 && (medium < 0 || bodies_[std::size_t(b)].priority >
                                                          bodies_[std::size_t(medium)].priority))
            medium = b;
    return medium;
}

bool Things::contains(std::size_t body, Vec3 p) const {
    const Body& b = bodies_[body];
    if (b.sphere) return length(p - b.sphere->centre) < b.sphere->radius;
    // The nearest face that a ray meets is met from within, if the point is. No edge of a scene
    // lies along this direction.
    const Vec3 d = normalised({0.3571, 0.6173, 0.7013});
    if (b.faces) return b.faces->holds(p);
    const auto out = crossing(b, p, d, true), in = crossing(b, p, d, false);
    return out && (!in || out->distance < in->distance);
}

Things::Ball Things::around_bodies() const { return around_bodies_; }
Things::Ball Things::around_all() const { return around_all_; }

}  // namespace dewbow::bench
