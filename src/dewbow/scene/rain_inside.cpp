// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/rain_inside.h"

#include "dewbow/sky/length_pieces.h"
#include "dewbow/sky/mirrored_way.h"

namespace dewbow {

WorldTriangles world_triangles(const MeshRegion& region) {
    WorldTriangles triangles;
    triangles.vertices.reserve(region.mesh->vertices.size());
    for (const Point<Object>& vertex : region.mesh->vertices)
        triangles.vertices.push_back(region.world_from_object(vertex).v);
    triangles.triangles = region.mesh->triangles;
    return triangles;
}

RainInside::RainInside(const Rain& rain) {
    if (const auto* convex = std::get_if<ConvexRegion>(&rain.region)) {
        inside_ = *convex;
        return;
    }
    WorldTriangles mesh = world_triangles(std::get<MeshRegion>(rain.region));
    inside_ = std::make_shared<const ClosedMesh>(mesh.vertices, std::move(mesh.triangles));
}

void RainInside::cut(Point<World> origin, Dir<World> direction, double length,
                     std::vector<LineInterval>& inside) const {
    if (const auto* convex = std::get_if<ConvexRegion>(&inside_)) {
        if (const auto part = convex->cut(origin, direction, length)) inside.push_back(*part);
    } else {
        std::get<1>(inside_)->cut(origin, direction, length, inside);
    }
}

double RainInside::length_inside(Point<World> origin, Dir<World> direction, double length) const {
    if (const auto* convex = std::get_if<ConvexRegion>(&inside_)) {
        const auto part = convex->cut(origin, direction, length);
        return part ? part->end - part->begin : 0.0;
    }
    std::vector<LineInterval> inside;
    std::get<1>(inside_)->cut(origin, direction, length, inside);
    double sum = 0.0;
    for (const LineInterval& part : inside) sum += part.end - part.begin;
    return sum;
}

void RainInside::lengths_towards(Point<World> origin, Dir<World> direction, LineInterval on,
                                 Dir<World> towards, std::vector<LengthPiece>& pieces) const {
    if (const auto* convex = std::get_if<ConvexRegion>(&inside_)) {
        convex->lengths_towards(origin, direction, on, towards, pieces);
    } else {
        std::get<1>(inside_)->lengths_towards(origin, direction, on, towards, pieces);
    }
}

void RainInside::lengths_down_to(double height_m, Point<World> origin, Dir<World> direction,
                                 LineInterval on, Dir<World> towards,
                                 std::vector<LengthPiece>& pieces) const {
    if (const auto* convex = std::get_if<ConvexRegion>(&inside_)) {
        convex->above(height_m).lengths_towards(origin, direction, on, towards, pieces);
        return;
    }
    // All of the way, without what lies beyond the plane.
    std::vector<LengthPiece> all, beyond;
    lengths_towards(origin, direction, on, towards, all);
    const LineOnPlane line(height_m, origin, direction, towards);
    line.lengths([&](Point<World> o, Dir<World> d, LineInterval part,
                     std::vector<LengthPiece>& out) { lengths_towards(o, d, part, towards, out); },
                 on, beyond);
    const std::vector<LengthPiece> difference = sum_of(all, beyond, -1.0);
    pieces.insert(pieces.end(), difference.begin(), difference.end());
}

}  // namespace dewbow
