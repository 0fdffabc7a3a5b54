// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dewbow/base/check.h"

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kLeafSize = 8;
/// Sine of the angle between two directions below which they are one: over 1 km the points of a ray
/// are off by 0.1 mm at most.
constexpr double kParallel = 1e-7;
/// By what share boxes of the tree are wider than their triangles, so that rounding loses none.
constexpr double kMargin = 1e-9;

/// Vertices at one place made one, and triangles without their three corners left out.
struct Welded {
    std::vector<Vec3> vertices;
    std::vector<TriangleIndices> triangles;
};

Welded weld(const std::vector<Vec3>& vertices, std::vector<TriangleIndices> triangles) {
    const auto place = [&](std::uint32_t i) {
        const Vec3 v = vertices[i];
        return std::array{v.x + 0.0, v.y + 0.0, v.z + 0.0};  // −0 is 0
    };
    std::vector<std::uint32_t> order(vertices.size()), name(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    Welded welded;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || place(order[i]) != place(order[i - 1]))
            welded.vertices.push_back(vertices[order[i]]);
        name[order[i]] = std::uint32_t(welded.vertices.size() - 1);
    }
    for (TriangleIndices& t : triangles) {
        for (std::uint32_t& corner : t) corner = name[corner];
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) welded.triangles.push_back(t);
    }
    return welded;
}

}  // namespace

std::optional<OpenEdges> ClosedMesh::open_edges(const std::vector<Vec3>& vertices,
                                                std::vector<TriangleIndices> triangles) {
    const Welded welded = weld(vertices, std::move(triangles));
    std::vector<std::array<std::uint32_t, 2>> edges;
    edges.reserve(3 * welded.triangles.size());
    for (const TriangleIndices& t : welded.triangles) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[std::size_t(k)], t[std::size_t((k + 1) % 3)]);
            edges.push_back({low, high});
        }
    }
    std::sort(edges.begin(), edges.end());
    std::optional<OpenEdges> open;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        if ((next - i) % 2 == 0) continue;
        if (!open) open = {0, welded.vertices[edges[i][0]], welded.vertices[edges[i][1]]};
        ++open->count;
    }
    return open;
}

ClosedMesh::ClosedMesh(const std::vector<Vec3>& vertices, std::vector<TriangleIndices> triangles) {
    DEWBOW_CHECK(!open_edges(vertices, triangles), "a mesh that rain falls in is closed");
    Welded welded = weld(vertices, std::move(triangles));
    vertices_ = std::move(welded.vertices);
    triangles_ = std::move(welded.triangles);
    if (!triangles_.empty()) build(0, std::uint32_t(triangles_.size()));
}

// ---- the tree: boxes halved at the median of their longest side --------------------------------

void ClosedMesh::build(std::uint32_t first, std::uint32_t count) {
    Vec3 low{kInfinity, kInfinity, kInfinity}, high = -low;
    for (std::uint32_t i = first; i < first + count; ++i) {
        for (const std::uint32_t corner : triangles_[i])
            low = min(low, vertices_[corner]), high = max(high, vertices_[corner]);
    }
    const Vec3 centre = 0.5 * (low + high), half = 0.5 * (high - low);
    const double margin = kMargin * (length(half) + length(centre));
    const std::size_t self = nodes_.size();
    nodes_.push_back({centre, half + Vec3{margin, margin, margin}, first, count, 0});
    if (count <= kLeafSize) return;
    const int axis = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    const auto middle_of = [&](const TriangleIndices& t) {
        return vertices_[t[0]][axis] + vertices_[t[1]][axis] + vertices_[t[2]][axis];
    };
    const auto begin = triangles_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count,
                     [&](const auto& a, const auto& b) { return middle_of(a) < middle_of(b); });
    nodes_[self].count = 0;
    build(first, count / 2);
    nodes_[self].right = std::uint32_t(nodes_.size());
    build(first + count / 2, count - count / 2);
}

void ClosedMesh::visit_triangles(const auto& may_meet, const auto& visit) const {
    std::array<std::uint32_t, 64> waiting;  // halves of at most 2^32 triangles
    std::size_t size = 0;
    if (!nodes_.empty()) waiting[size++] = 0;
    while (size > 0) {
        const std::uint32_t at = waiting[--size];
        const Node& node = nodes_[at];
        if (!may_meet(node.centre, node.half)) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(triangles_[i]);
        if (node.count > 0) continue;
        waiting[size++] = node.right;
        waiting[size++] = at + 1;
    }
}

// ---- polygons in a plane -----------------------------------------------------------------------

/// Oblique coordinates in the plane of two directions: point = origin + s along + t across, and the
/// height above it.
struct ClosedMesh::Slice {
    Slice(Vec3 o, Vec3 d, Vec3 e) : origin(o) {
        const double cosine = dot(d, e), sine_squared = 1.0 - cosine * cosine;
        normal = normalised(cross(d, e));
        along = (d - cosine * e) / sine_squared;
        across = (e - cosine * d) / sine_squared;
    }
    bool above(Vec3 p) const { return dot(normal, p - origin) >= 0.0; }
    bool meets_plane(Vec3 centre, Vec3 half) const {
        return std::abs(dot(normal, centre - origin)) <= reach(normal, half);
    }
    /// How far a box of that half size reaches from its centre along `v`.
    static double reach(Vec3 v, Vec3 half) {
        return std::abs(v.x) * half.x + std::abs(v.y) * half.y + std::abs(v.z) * half.z;
    }

    Vec3 origin, normal, along, across;
};

/// A triangle's part of a polygon, from smaller s to larger.
struct ClosedMesh::Segment {
    double s0, t0, s1, t1;

    double t_at(double s) const { return t0 + slope() * (s - s0); }
    double slope() const { return (t1 - t0) / (s1 - s0); }
    /// Of a side that goes from one side of t = 0 to the other.
    double s_of_zero() const { return s0 + (s1 - s0) * (t0 / (t0 - t1)); }
};

void ClosedMesh::cut_by_plane(const Slice& slice, const auto& may_meet,
                              std::vector<Segment>& found) const {
    // The place where an edge goes through the plane; the same for both of its triangles.
    const auto crossing = [&](std::uint32_t i, std::uint32_t j) {
        const Vec3 a = vertices_[std::min(i, j)] - slice.origin;
        const Vec3 b = vertices_[std::max(i, j)] - slice.origin;
        const double ha = dot(slice.normal, a), hb = dot(slice.normal, b);
        const Vec3 p = a + (b - a) * (ha / (ha - hb));
        return std::pair{dot(slice.along, p), dot(slice.across, p)};
    };
    visit_triangles(may_meet, [&](const TriangleIndices& t) {
        std::array<bool, 3> above;
        for (std::size_t k = 0; k < 3; ++k) above[k] = slice.above(vertices_[t[k]]);
        if (above[0] == above[1] && above[1] == above[2]) return;
        // The corner that is alone on its side.
        const std::size_t alone = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;
        auto [s0, t0] = crossing(t[alone], t[(alone + 1) % 3]);
        auto [s1, t1] = crossing(t[alone], t[(alone + 2) % 3]);
        if (s1 < s0) std::swap(s0, s1), std::swap(t0, t1);
        found.push_back({s0, t0, s1, t1});
    });
}

std::vector<double> ClosedMesh::crossings(Point<World> origin, Dir<World> direction) const {
    const Slice slice(origin.v, direction.v, tangents_of(direction.v).t);
    const auto near_line = [&](Vec3 centre, Vec3 half) {
        return slice.meets_plane(centre, half) &&
               std::abs(dot(slice.across, centre - slice.origin)) <=
                   Slice::reach(slice.across, half);
    };
    std::vector<Segment> polygon;
    cut_by_plane(slice, near_line, polygon);
    std::vector<double> met;
    for (const Segment& side : polygon) {
        if ((side.t0 >= 0.0) != (side.t1 >= 0.0)) met.push_back(side.s_of_zero());
    }
    std::sort(met.begin(), met.end());
    return met;
}

void ClosedMesh::cut(Point<World> origin, Dir<World> direction, double length,
                     std::vector<LineInterval>& inside) const {
    const std::vector<double> met = crossings(origin, direction);
    for (std::size_t i = 0; i + 1 < met.size(); i += 2) {
        const LineInterval part{std::max(0.0, met[i]), std::min(length, met[i + 1])};
        if (part.begin < part.end) inside.push_back(part);
    }
}

// ---- the way towards the light -----------------------------------------------------------------

namespace {

/// Where the pieces of `on` begin and end: at all ends of the segments within it.
std::vector<double> breaks_of(const auto& segments, LineInterval on) {
    std::vector<double> breaks{on.begin, on.end};
    for (const auto& segment : segments) {
        for (const double s : {segment.s0, segment.s1}) {
            if (s > on.begin && s < on.end) breaks.push_back(s);
        }
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

/// The piece from `begin` to `end` above a polygon's `sides`, all of which reach over it: from the
/// outermost one inwards every second stretch is inside, down to 0.
LengthPiece piece_above(auto& sides, double begin, double end) {
    const double middle = end < kInfinity ? 0.5 * (begin + end) : begin + 1.0;
    std::sort(sides.begin(), sides.end(),
              [&](const auto& a, const auto& b) { return a.t_at(middle) > b.t_at(middle); });
    LengthPiece piece{begin, end, 0.0, 0.0};
    double sign = 1.0;
    for (const auto& side : sides) {
        piece.length += sign * side.t_at(begin);
        piece.slope += sign * side.slope();
        sign = -sign;
    }
    piece.length = std::max(0.0, piece.length);
    return piece;
}

}  // namespace

/// What of the sides of a polygon lies above t = 0 and within `on`; upright ones bound nothing.
std::vector<ClosedMesh::Segment> ClosedMesh::upper_part(const std::vector<Segment>& polygon,
                                                        LineInterval on) {
    std::vector<Segment> upper;
    for (Segment side : polygon) {
        if (side.t0 <= 0.0 && side.t1 <= 0.0) continue;
        if (side.t0 < 0.0) {
            side.s0 = side.s_of_zero(), side.t0 = 0.0;
        } else if (side.t1 < 0.0) {
            side.s1 = side.s_of_zero(), side.t1 = 0.0;
        }
        if (side.s0 < side.s1 && side.s1 > on.begin && side.s0 < on.end) upper.push_back(side);
    }
    std::sort(upper.begin(), upper.end(),
              [](const Segment& a, const Segment& b) { return a.s0 < b.s0; });
    return upper;
}

void ClosedMesh::lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                                 Dir<World> towards, std::vector<LengthPiece>& pieces) const {
    if (!(on.begin < on.end)) return;
    if (length(cross(direction.v, towards.v)) < kParallel) {
        lengths_along(origin, direction, on, dot(direction, towards) > 0.0, pieces);
        return;
    }
    const Slice slice(origin.v, direction.v, towards.v);
    std::vector<Segment> polygon;
    cut_by_plane(
        slice, [&](Vec3 centre, Vec3 half) { return slice.meets_plane(centre, half); }, polygon);
    const std::vector<Segment> upper = upper_part(polygon, on);
    const std::vector<double> breaks = breaks_of(upper, on);
    std::vector<Segment> sides;  // that reach over the present piece
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double begin = breaks[i], end = breaks[i + 1];
        std::erase_if(sides, [&](const Segment& side) { return side.s1 <= begin; });
        while (next < upper.size() && upper[next].s0 <= begin) sides.push_back(upper[next++]);
        pieces.push_back(piece_above(sides, begin, end));
    }
}

/// The light comes along the line itself, from ahead or from behind.
void ClosedMesh::lengths_along(Point<World> origin, Dir<World> direction, LineInterval on,
                               bool ahead, std::vector<LengthPiece>& pieces) const {
    const std::vector<double> met = crossings(origin, direction);
    double begin = on.begin;
    for (std::size_t i = 0; begin < on.end; ++i) {
        const double end = i < met.size() ? std::min(on.end, met[i]) : on.end;
        if (end <= begin) continue;
        double way = 0.0;  // of `begin`
        for (std::size_t k = 0; k + 1 < met.size(); k += 2) {
            way += ahead ? std::max(0.0, met[k + 1] - std::max(met[k], begin))
                         : std::max(0.0, std::min(met[k + 1], begin) - met[k]);
        }
        const bool inside = i % 2 == 1;
        pieces.push_back({begin, end, way, !inside ? 0.0 : ahead ? -1.0 : 1.0});
        begin = end;
    }
}

}  // namespace dewbow
