// SPDX-License-Identifier: Apache-2.0
#include "emission.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/vector.h"
#include "even_points.h"

namespace dewbow::bench {
namespace {

constexpr double kPi = std::numbers::pi;

/// Two unit vectors that make a frame with `axis`; the first is level where it can be.
std::array<Vec3, 2> level_frame(Vec3 axis) {
    const Vec3 up = std::abs(axis.y) < 0.99 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const Vec3 u = normalised(cross(up, axis));
    return {u, cross(axis, u)};
}

}  // namespace

std::array<double, 2> point_in_disc(double u, double v) {
    const double r = std::sqrt(u), phi = 2.0 * kPi * v;
    return {r * std::cos(phi), r * std::sin(phi)};
}

Vec3 point_of(const PlainLamp& lamp, double u, double v) {
    if (lamp.shape == LampShape::rectangle)
        return lamp.centre + lamp.half_u * (2.0 * u - 1.0) + lamp.half_v * (2.0 * v - 1.0);
    const auto p = point_in_disc(u, v);
    return lamp.centre + lamp.half_u * p[0] + lamp.half_v * p[1];
}

double area_m2(const PlainLamp& lamp) {
    return length(cross(lamp.half_u, lamp.half_v)) * (lamp.shape == LampShape::disc ? kPi : 4.0);
}

Vec3 direction_from(const PlainSun& sun, double u, double v) {
    const auto frame = level_frame(sun.direction);
    const auto p = point_in_disc(u, v);
    const double sine = std::sin(sun.angular_radius_rad), x = p[0] * sine, y = p[1] * sine;
    return frame[0] * x + frame[1] * y + sun.direction * std::sqrt(1.0 - x * x - y * y);
}

Emission::Emission(const PlainScene& scene, const Things& things) : scene_(scene), things_(things) {
    constexpr int kRounds = 4;
    const int sources = int(scene.lamps.size() + scene.spots.size() + scene.suns.size());
    for (const PlainLamp& lamp : scene.lamps)
        if (lamp.two_sided) throw InputError("the lamp '" + lamp.name + "' has one side");
    for (int source = 0; source < sources; ++source) {
        gates_.push_back(first_gate(source));
        for (int round = 0; round < kRounds; ++round) gates_.back() = narrower(source);
    }
}

EmittedRay Emission::through_gate(int source, const std::array<double, 4>& u) const {
    const Gate& gate = gates_[std::size_t(source)];
    const Vec3 target = gate.at(2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0);
    const auto lamps = int(scene_.lamps.size()), spots = int(scene_.spots.size());
    EmittedRay ray{{}, {}, gate.area_m2(), source};
    if (source < lamps + spots) {
        const bool is_lamp = source < lamps;
        ray.origin = is_lamp ? point_of(scene_.lamps[std::size_t(source)], u[2], u[3])
                             : scene_.spots[std::size_t(source - lamps)].position;
        const Vec3 to = target - ray.origin;
        ray.d = normalised(to);
        ray.weight *= std::abs(dot(ray.d, gate.normal())) / dot(to, to);
        if (is_lamp) {
            const PlainLamp& lamp = scene_.lamps[std::size_t(source)];
            ray.weight *= area_m2(lamp) * std::max(0.0, dot(ray.d, lamp.normal));
        } else {
            const PlainSpot& spot = scene_.spots[std::size_t(source - lamps)];
            if (dot(ray.d, spot.direction) < std::cos(spot.half_angle_rad)) ray.weight = 0.0;
        }
        return ray;
    }
    const PlainSun& sun = scene_.suns[std::size_t(source - lamps - spots)];
    ray.d = direction_from(sun, u[2], u[3]);
    ray.origin = target - ray.d * (2.0 * things_.around_all().radius);
    ray.weight *= std::abs(dot(ray.d, gate.normal())) / dot(ray.d, sun.direction);
    return ray;
}

EmittedRay Emission::elsewhere(int source, const std::array<double, 4>& u) const {
    const auto lamps = int(scene_.lamps.size()), spots = int(scene_.spots.size());
    EmittedRay ray{{}, {}, 0.0, source};
    if (source < lamps) {
        const PlainLamp& lamp = scene_.lamps[std::size_t(source)];
        ray.origin = point_of(lamp, u[2], u[3]);
        const auto frame = level_frame(lamp.normal);
        const auto p = point_in_disc(u[0], u[1]);
        ray.d = normalised(frame[0] * p[0] + frame[1] * p[1] +
                           lamp.normal * std::sqrt(std::max(0.0, 1.0 - u[0])));
        ray.weight = kPi * area_m2(lamp);
    } else if (source < lamps + spots) {
        const PlainSpot& spot = scene_.spots[std::size_t(source - lamps)];
        const double height = 1.0 - std::cos(spot.half_angle_rad), cosine = 1.0 - u[0] * height;
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), phi = 2.0 * kPi * u[1];
        const auto frame = level_frame(spot.direction);
        ray.origin = spot.position;
        ray.d = frame[0] * (sine * std::cos(phi)) + frame[1] * (sine * std::sin(phi)) +
                spot.direction * cosine;
        ray.weight = 2.0 * kPi * height;
    } else {
        const PlainSun& sun = scene_.suns[std::size_t(source - lamps - spots)];
        const auto all = things_.around_all();
        const auto p = point_in_disc(u[0], u[1]);
        ray.d = direction_from(sun, u[2], u[3]);
        const auto across = level_frame(ray.d);
        // The disc holds the whole scene as the ray's direction sees it.
        ray.origin = all.centre + (across[0] * p[0] + across[1] * p[1]) * all.radius -
                     ray.d * (2.0 * all.radius);
        ray.weight = kPi * all.radius * all.radius / dot(ray.d, sun.direction);
    }
    if (gates_[std::size_t(source)].holds(ray.origin, ray.d)) ray.weight = 0.0;
    return ray;
}

bool Emission::Gate::holds(Vec3 origin, Vec3 d) const {
    const Vec3 n = normal();
    const double distance = dot(centre - origin, n) / dot(d, n);
    if (!(distance > 0.0)) return false;
    const Vec3 p = origin + d * distance - centre;
    return std::abs(dot(p, half_u)) <= dot(half_u, half_u) &&
           std::abs(dot(p, half_v)) <= dot(half_v, half_v);
}

Emission::Gate Emission::first_gate(int source) const {
    /// The bodies' ball as points of a lamp at a distance of two radii or more see it.
    constexpr double kWider = 1.3;
    const auto lamps = int(scene_.lamps.size()), spots = int(scene_.spots.size());
    const auto ball = things_.around_bodies();
    Vec3 axis;
    double lamp_radius = 0.0;
    if (source < lamps) {
        const PlainLamp& lamp = scene_.lamps[std::size_t(source)];
        axis = ball.centre - lamp.centre;
        lamp_radius = length(lamp.half_u) + length(lamp.half_v);
    } else if (source < lamps + spots) {
        axis = ball.centre - scene_.spots[std::size_t(source - lamps)].position;
    } else {
        axis = scene_.suns[std::size_t(source - lamps - spots)].direction;
    }
    const double half = kWider * ball.radius + lamp_radius;
    const auto frame = level_frame(normalised(axis));
    return {ball.centre, frame[0] * half, frame[1] * half};
}

Emission::Gate Emission::narrower(int source) const {
    constexpr std::uint64_t kRays = 1 << 16;
    /// What is added on each side, as a share of what was found.
    constexpr double kMargin = 0.02;
    const Gate& gate = gates_[std::size_t(source)];
    std::array<double, 2> low{1.0, 1.0}, high{-1.0, -1.0};
    const EvenPoints<4> points(1);
    for (std::uint64_t i = 0; i < kRays; ++i) {
        const auto u = points[i];
        const EmittedRay ray = through_gate(source, u);
        if (ray.weight == 0.0) continue;
        const auto met = things_.first(ray.origin, ray.d, 0);
        if (!met || met->body < 0) continue;
        for (const std::size_t k : {0u, 1u}) {
            low[k] = std::min(low[k], 2.0 * u[k] - 1.0);
            high[k] = std::max(high[k], 2.0 * u[k] - 1.0);
        }
    }
    if (low[0] >= high[0]) return gate;
    std::array<double, 2> middle{}, half{};
    for (const std::size_t k : {0u, 1u}) {
        middle[k] = 0.5 * (low[k] + high[k]);
        half[k] = (0.5 + kMargin) * (high[k] - low[k]);
    }
    return {gate.at(middle[0], middle[1]), gate.half_u * half[0], gate.half_v * half[1]};
}

}  // namespace dewbow::bench
