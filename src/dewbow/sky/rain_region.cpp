// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/rain_region.h"

#include <algorithm>
#include <limits>

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Cosine by which two normals may miss being opposite: a hundred roundings.
constexpr double kOpposite = 1e-14;

/// value + slope (s - where the line's stretch begins)
struct Linear {
    double value, slope;
};

/// Takes away the part of `on` where `function`, measured from `on_begin`, is negative.
void keep_positive(Linear function, double on_begin, LineInterval& on) {
    if (function.slope == 0.0) {
        if (function.value < 0.0) on.end = on.begin;
        return;
    }
    const double zero = on_begin - function.value / function.slope;
    if (function.slope > 0.0) {
        on.begin = std::max(on.begin, zero);
    } else {
        on.end = std::min(on.end, zero);
    }
}

/// The ways from the points of a line to the faces of a region.
struct Ways {
    std::vector<Linear> to_leave;  ///< to faces that the light's way, followed back, goes out by
    std::vector<Linear> to_enter;  ///< to faces that it comes in by; and 0, the point itself
    LineInterval lit;              ///< where the ways are in the region at all
};

/// @param on  finite at its begin
Ways ways_to_faces(std::span<const HalfSpace> half_spaces, Vec3 origin, Vec3 direction,
                   LineInterval on, Vec3 towards) {
    Ways ways{{}, {{0.0, 0.0}}, on};
    for (const HalfSpace& face : half_spaces) {
        const Linear room{
            face.offset - dot(face.normal, origin) - dot(face.normal, direction) * on.begin,
            -dot(face.normal, direction)};
        const double cosine = dot(face.normal, towards);
        if (cosine == 0.0) {
            keep_positive(room, on.begin, ways.lit);
            continue;
        }
        const Linear way{room.value / cosine, room.slope / cosine};
        (cosine > 0.0 ? ways.to_leave : ways.to_enter).push_back(way);
    }
    return ways;
}

/// The least of linear functions on `on`, piece by piece.   Cost: functions × pieces.
void append_least(std::span<const Linear> functions, double origin, LineInterval on,
                  std::vector<LengthPiece>& pieces) {
    const auto at = [&](const Linear& f, double s) { return f.value + f.slope * (s - origin); };
    const auto first =
        std::min_element(functions.begin(), functions.end(), [&](const Linear& a, const Linear& b) {
            const double va = at(a, on.begin), vb = at(b, on.begin);
            return va < vb || (va == vb && a.slope < b.slope);
        });
    Linear least = *first;
    double begin = on.begin;
    while (begin < on.end) {
        Linear next = least;
        double end = on.end;
        for (const Linear& f : functions) {
            if (f.slope >= least.slope) continue;
            const double crossing =
                std::max(begin, origin + (f.value - least.value) / (least.slope - f.slope));
            if (crossing < end ||
                (crossing == end && f.slope < next.slope && next.slope < least.slope)) {
                end = crossing, next = f;
            }
        }
        if (end > begin)
            pieces.push_back({begin, end, std::max(0.0, at(least, begin)), least.slope});
        begin = end, least = next;
        if (end == on.end) break;
    }
}

}  // namespace

ConvexRegion::ConvexRegion(std::vector<HalfSpace> half_spaces)
    : half_spaces_(std::move(half_spaces)) {}

ConvexRegion ConvexRegion::layer(Length bottom, Length top) {
    return ConvexRegion({{{0, -1, 0}, -bottom.to(unit::m)}, {{0, 1, 0}, top.to(unit::m)}});
}

ConvexRegion ConvexRegion::box(const Transform<World, Object>& world_from_box, Vec3 half) {
    std::vector<HalfSpace> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 out = side * Vec3{double(axis == 0), double(axis == 1), double(axis == 2)};
            const Vec3 normal = world_from_box(Normal<Object>{out}).v;
            const Vec3 on_face = world_from_box(Point<Object>{out * half[axis]}).v;
            faces.push_back({normal, dot(normal, on_face)});
        }
    }
    return ConvexRegion(std::move(faces));
}

ConvexRegion ConvexRegion::curtain(Point<World> from, Point<World> to, Length thickness,
                                   Length bottom, Length top) {
    const Vec3 level{to.v.x - from.v.x, 0.0, to.v.z - from.v.z};
    const Vec3 on = normalised(level), across{-on.z, 0.0, on.x};
    const double half = 0.5 * thickness.to(unit::m);
    ConvexRegion region = layer(bottom, top);
    const double middle = dot(across, from.v);
    region.half_spaces_.insert(region.half_spaces_.end(), {{across, middle + half},
                                                           {-across, half - middle},
                                                           {on, dot(on, to.v)},
                                                           {-on, -dot(on, from.v)}});
    return region;
}

ConvexRegion ConvexRegion::above(double height_m) const {
    ConvexRegion region = *this;
    region.half_spaces_.push_back({{0, -1, 0}, -height_m});
    return region;
}

bool ConvexRegion::contains(Point<World> point) const {
    return std::all_of(half_spaces_.begin(), half_spaces_.end(), [&](const HalfSpace& face) {
        return dot(face.normal, point.v) <= face.offset;
    });
}

std::optional<Length> ConvexRegion::thickness() const {
    double least = kInfinity;
    for (const HalfSpace& a : half_spaces_) {
        for (const HalfSpace& b : half_spaces_) {
            if (dot(a.normal, b.normal) < kOpposite - 1.0)
                least = std::min(least, a.offset + b.offset);
        }
    }
    if (least == kInfinity) return std::nullopt;
    return least * unit::m;
}

std::optional<LineInterval> ConvexRegion::cut(Point<World> origin, Dir<World> direction,
                                              double length) const {
    LineInterval inside{0.0, length};
    for (const HalfSpace& face : half_spaces_) {
        keep_positive({face.offset - dot(face.normal, origin.v), -dot(face.normal, direction.v)},
                      0.0, inside);
    }
    if (!(inside.begin < inside.end)) return std::nullopt;
    return inside;
}

void ConvexRegion::lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                                   Dir<World> towards, std::vector<LengthPiece>& pieces) const {
    Ways ways = ways_to_faces(half_spaces_, origin.v, direction.v, on, towards.v);
    std::vector<Linear> differences;
    for (const Linear& leave : ways.to_leave) {
        for (const Linear& enter : ways.to_enter)
            differences.push_back({leave.value - enter.value, leave.slope - enter.slope});
    }
    LineInterval lit = ways.lit;
    for (const Linear& difference : differences) keep_positive(difference, on.begin, lit);
    if (!(lit.begin < lit.end)) {
        if (on.begin < on.end) pieces.push_back({on.begin, on.end, 0.0, 0.0});
        return;
    }
    if (on.begin < lit.begin) pieces.push_back({on.begin, lit.begin, 0.0, 0.0});
    if (differences.empty()) {
        pieces.push_back({lit.begin, lit.end, kInfinity, 0.0});
    } else {
        append_least(differences, on.begin, lit, pieces);
    }
    if (lit.end < on.end) pieces.push_back({lit.end, on.end, 0.0, 0.0});
}

}  // namespace dewbow
