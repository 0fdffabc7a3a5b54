// SPDX-License-Identifier: Apache-2.0
#include "clear_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/base/error.h"

namespace dewbow::bench {
namespace {

/// Corners in files have nine digits: how far they may lie off a plane, as a share of the body's
/// size.
constexpr double kFlat = 1e-6;

}  // namespace

Parting part(Vec3 d, Vec3 normal, double n) {
    const double cos_i = std::min(1.0, -dot(d, normal));
    Parting parting;
    parting.reflected = d + normal * (2.0 * cos_i);
    const double sin2_t = (1.0 - cos_i * cos_i) / (n * n);
    if (sin2_t >= 1.0) return parting;
    const double cos_t = std::sqrt(1.0 - sin2_t);
    parting.refracted = normalised(d / n + normal * (cos_i / n - cos_t));
    const double s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    const double p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    parting.reflectance = 0.5 * (s * s + p * p);
    return parting;
}

ConvexFaces::ConvexFaces(const PlainBody& body) {
    Vec3 low = body.vertices.front(), high = low;
    for (const Vec3 v : body.vertices) low = min(low, v), high = max(high, v);
    const double slack = kFlat * length(high - low);
    for (const auto& triangle : body.triangles) {
        const Vec3 a = body.vertices[triangle[0]];
        const Vec3 area = cross(body.vertices[triangle[1]] - a, body.vertices[triangle[2]] - a);
        if (length(area) <= slack * slack) continue;
        const Face face{normalised(area), dot(normalised(area), a)};
        for (const Vec3 v : body.vertices)
            if (dot(face.normal, v) > face.offset + slack)
                throw InputError("the benchmark's clear body is not convex");
        const bool known = std::any_of(planes_.begin(), planes_.end(), [&](const Face& other) {
            return length(other.normal - face.normal) < kFlat;
        });
        if (!known) planes_.push_back(face);
    }
}

std::optional<ConvexFaces::Crossing> ConvexFaces::entry(Vec3 origin, Vec3 d) const {
    Crossing in{0.0, {}};
    double out = std::numeric_limits<double>::infinity();
    for (const Face& face : planes_) {
        const double above = dot(face.normal, origin) - face.offset, rate = dot(face.normal, d);
        if (rate == 0.0) {
            if (above > 0.0) return std::nullopt;
        } else if (rate < 0.0) {
            if (-above / rate > in.distance) in = {-above / rate, face.normal};
        } else {
            out = std::min(out, -above / rate);
        }
    }
    if (in.distance <= 0.0 || in.distance >= out) return std::nullopt;
    return in;
}

ConvexFaces::Crossing ConvexFaces::exit(Vec3 origin, Vec3 d) const {
    const Face* nearest = nullptr;
    double nearest_below = 1.0, nearest_rate = 0.0;  // distance = below / rate, infinite at first
    for (const Face& face : planes_) {
        const double rate = dot(face.normal, d);
        const double below = face.offset - dot(face.normal, origin);
        // One condition, rarely true: half of the faces look away, and which is not predictable.
        if ((rate > 0.0) & (below * nearest_rate < nearest_below * rate))
            nearest = &face, nearest_below = below, nearest_rate = rate;
    }
    return {std::max(0.0, nearest_below / nearest_rate), nearest->normal};
}

bool ConvexFaces::holds(Vec3 p) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const Face& face) { return dot(face.normal, p) < face.offset; });
}

std::optional<double> distance_to(const PlainLamp& lamp, Vec3 origin, Vec3 d) {
    const double rate = dot(lamp.normal, d);
    if (rate == 0.0) return std::nullopt;
    const double distance = dot(lamp.normal, lamp.centre - origin) / rate;
    if (distance <= 0.0) return std::nullopt;
    const Vec3 from_centre = origin + d * distance - lamp.centre;
    const double u = dot(from_centre, lamp.half_u) / dot(lamp.half_u, lamp.half_u);
    const double v = dot(from_centre, lamp.half_v) / dot(lamp.half_v, lamp.half_v);
    const bool inside = lamp.shape == LampShape::disc ? u * u + v * v <= 1.0
                                                      : std::abs(u) <= 1.0 && std::abs(v) <= 1.0;
    return inside ? std::optional(distance) : std::nullopt;
}

}  // namespace dewbow::bench
