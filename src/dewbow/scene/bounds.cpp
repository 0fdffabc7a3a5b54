// SPDX-License-Identifier: Apache-2.0
#include <unordered_map>

#include "dewbow/scene/scene.h"

namespace dewbow {
namespace {

void add_corners(Bounds& bounds, const Affine& world_from_object, Vec3 low, Vec3 high) {
    for (int corner = 0; corner < 8; ++corner) {
        bounds.add(
            world_from_object.apply({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                     corner & 4 ? high.z : low.z}));
    }
}

/// The image of the ball (or, with `axes` 2, of the disc in z = 0) of `radius` around the origin.
/// Along a world axis it reaches radius × the length of that row of the matrix.
void add_round(Bounds& bounds, const Affine& world_from_object, double radius, int axes) {
    const auto reach = [&](int row) {
        const auto& m = world_from_object.m[std::size_t(row)];
        return radius * length({m[0], m[1], axes == 3 ? m[2] : 0.0});
    };
    const Vec3 half{reach(0), reach(1), reach(2)};
    const Vec3 centre = world_from_object.apply({});
    bounds.add(centre - half);
    bounds.add(centre + half);
}

struct AddGeometry {
    Bounds& bounds;
    const Affine& world_from_object;

    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        for (const Point<Object>& vertex : mesh->vertices)
            bounds.add(world_from_object.apply(vertex.v));
    }
    void operator()(const Sphere& sphere) const {
        add_round(bounds, world_from_object, sphere.radius.to(unit::m), 3);
    }
    void operator()(const Disc& disc) const {
        add_round(bounds, world_from_object, disc.radius.to(unit::m), 2);
    }
    void operator()(const Rectangle& rectangle) const {
        const Vec3 half{rectangle.width.to(unit::m) / 2, rectangle.height.to(unit::m) / 2, 0.0};
        add_corners(bounds, world_from_object, -half, half);
    }
    void operator()(const Box& box) const {
        const Vec3 half{box.width.to(unit::m) / 2, box.height.to(unit::m) / 2,
                        box.depth.to(unit::m) / 2};
        add_corners(bounds, world_from_object, -half, half);
    }
    void operator()(const Prism& prism) const {
        // The centroid of a triangle lies at a third of its height.
        const double side = prism.side.to(unit::m);
        const double height = side * cos(prism.apex / 2.0);
        const double half_base = side * sin(prism.apex / 2.0);
        for (const double z : {-prism.length.to(unit::m) / 2, prism.length.to(unit::m) / 2}) {
            bounds.add(world_from_object.apply({0.0, height * 2 / 3, z}));
            bounds.add(world_from_object.apply({-half_base, -height / 3, z}));
            bounds.add(world_from_object.apply({half_base, -height / 3, z}));
        }
    }
    void operator()(const Plane&) const {}
};

}  // namespace

void Bounds::add(Vec3 p) {
    low = min(low, p);
    high = max(high, p);
}

Bounds bounds_of_box(const Bounds& box, const Affine& to_from_box) {
    Bounds corners, ball;
    add_corners(corners, to_from_box, box.low, box.high);
    add_round(ball, to_from_box * translation(box.centre()), box.radius(), 3);
    Bounds both;
    both.low = max(corners.low, ball.low);
    both.high = min(corners.high, ball.high);
    return both;
}

Bounds bounds_of(const Shape& shape) {
    Bounds bounds;
    std::visit(AddGeometry{bounds, shape.world_from_object.affine()}, shape.geometry);
    return bounds;
}

std::vector<Bounds> bounds_of_shapes(const Scene& scene) {
    constexpr std::size_t kMostVertices = 10'000'000;  // of one mesh in all its places: 0.1 s
    const auto mesh_of = [](const Shape& shape) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
        return mesh ? mesh->get() : nullptr;
    };
    std::unordered_map<const Mesh*, std::size_t> uses;
    for (const Shape& shape : scene.shapes)
        if (const Mesh* mesh = mesh_of(shape)) ++uses[mesh];
    std::unordered_map<const Mesh*, Bounds> boxes;
    std::vector<Bounds> result;
    result.reserve(scene.shapes.size());
    for (const Shape& shape : scene.shapes) {
        const Mesh* mesh = mesh_of(shape);
        if (!mesh || uses[mesh] == 1 || uses[mesh] * mesh->vertices.size() <= kMostVertices) {
            result.push_back(bounds_of(shape));
            continue;
        }
        Bounds& box = boxes[mesh];
        if (box.empty())
            for (const Point<Object>& vertex : mesh->vertices) box.add(vertex.v);
        result.push_back(bounds_of_box(box, shape.world_from_object.affine()));
    }
    return result;
}

Bounds bounds_of(const Scene& scene) {
    Bounds bounds;
    for (const Bounds& own : bounds_of_shapes(scene)) {
        if (own.empty()) continue;
        bounds.add(own.low);
        bounds.add(own.high);
    }
    return bounds;
}

}  // namespace dewbow
