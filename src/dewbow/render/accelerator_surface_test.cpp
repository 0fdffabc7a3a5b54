// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/accelerator.h"

namespace dewbow {
namespace {

using unit::deg;
using unit::m;

/// Texture coordinates in meshes are floats.
constexpr double kFloat = 3e-6;
const Affine kAskew = translation({0.3, -0.2, 0.1}) * rotation(normalised({1, 2, 3}), 40.0 * deg) *
                      scaling({1.0, 0.5, 2.0});

/// A cube of side 1, each face with coordinates that are linear in the place: u = dot(p, U) + …
/// One set of vertices a triangle, so that coordinates may jump at edges.
struct Face {
    Vec3 normal, u_axis, v_axis;
};
std::vector<Face> faces() {
    std::vector<Face> result;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            std::array<double, 3> n{}, u{}, v{};
            n[std::size_t(axis)] = sign;
            u[std::size_t((axis + 1) % 3)] = 1.0 + axis;
            u[std::size_t((axis + 2) % 3)] = 0.25;
            v[std::size_t((axis + 2) % 3)] = -2.0 * sign;
            result.push_back({{n[0], n[1], n[2]}, {u[0], u[1], u[2]}, {v[0], v[1], v[2]}});
        }
    return result;
}
/// Whether a point of a face lies on the second of its triangles.
bool second_half(const Face& face, Vec3 p) {
    const Tangents t = tangents_of(face.normal);
    return dot(p, t.b) > dot(p, t.t);
}
/// The second triangle of each face has its u, v further on by this.
constexpr double kJump = 10.0;

std::shared_ptr<Mesh> cube_with_coordinates() {
    auto mesh = std::make_shared<Mesh>();
    for (const Face& face : faces()) {
        const Tangents t = tangents_of(face.normal);
        const auto add = [&](double x, double y, double jump) {
            const Vec3 p = face.normal * 0.5 + t.t * x + t.b * y;
            mesh->vertices.push_back({p});
            mesh->texcoords[1].push_back(
                {float(dot(p, face.u_axis) + jump), float(dot(p, face.v_axis) + jump)});
            mesh->colours.push_back({float(p.x + 0.5), float(p.y + 0.5), float(p.z + 0.5), 1.0f});
        };
        const auto first = std::uint32_t(mesh->vertices.size());
        add(-0.5, -0.5, 0.0), add(0.5, -0.5, 0.0), add(0.5, 0.5, 0.0);
        add(-0.5, -0.5, kJump), add(0.5, 0.5, kJump), add(-0.5, 0.5, kJump);
        mesh->triangles.push_back({first, first + 1, first + 2});
        mesh->triangles.push_back({first + 3, first + 4, first + 5});
    }
    return mesh;
}
Scene scene_of(Geometry geometry, const Affine& place) {
    Scene scene = make_empty_scene();
    scene.add({"black", Black{}});
    scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), 0});
    return scene;
}
Vec3 random_direction(std::uint32_t i, std::uint32_t vertex) {
    const auto a = SampleKey(21, i).two(vertex, Purpose::test);
    return sample_uniform_sphere<World>(a[0], a[1]).v;
}

/// From outside, and from inside, where the accelerator knows the cube as a convex solid.
TEST(AcceleratorSurface, CoordinatesAndAxesOfAMeshAreThoseOfThePlace) {
    for (const Affine& place : {kAskew, kAskew * scaling({-1.0, 1.0, 1.0})}) {
        const Scene scene = scene_of(std::shared_ptr<const Mesh>(cube_with_coordinates()), place);
        const Accelerator tree(scene, {false});
        const Affine local = place.inverse().value();
        for (std::uint32_t i = 0; i < 4000; ++i) {
            const Vec3 o = place.apply(2.0 * random_direction(i, 0));
            const Vec3 target = place.apply(0.5 * random_direction(i, 1));
            Ray ray{o, normalised(target - o), {}};
            for (int k = 0; k < 2; ++k) {
                const Hit hit = tree.intersect(ray);
                if (!hit) break;
                const Vec3 point = ray.origin + ray.direction * hit.t, p = local.apply(point);
                const Face face = faces()[std::size_t(hit.primitive / 2)];
                const SurfaceCoordinates at = tree.coordinates(hit, point);
                const double jump = second_half(face, p) ? kJump : 0.0;
                for (const TexturePoint& uv : at.uv) {  // the one set stands for both
                    ASSERT_NEAR(uv.u, dot(p, face.u_axis) + jump, kFloat);
                    ASSERT_NEAR(uv.v, dot(p, face.v_axis) + jump, kFloat);
                }
                ASSERT_NEAR(at.colour[1], p.y + 0.5, kFloat);
                // One step to the right is u + 1 and v + 0; one up is v − 1.
                const PictureAxes axes = tree.picture_axes(hit, point, 1);
                const Vec3 right = local.apply_linear(axes.right), up = local.apply_linear(axes.up);
                ASSERT_NEAR(dot(right, face.u_axis), 1.0, kFloat);
                ASSERT_NEAR(dot(right, face.v_axis), 0.0, kFloat);
                ASSERT_NEAR(dot(up, face.u_axis), 0.0, kFloat);
                ASSERT_NEAR(dot(up, face.v_axis), -1.0, kFloat);
                ASSERT_NEAR(dot(right, face.normal), 0.0, kFloat);
                ray = {point, normalised(target - o), {0, hit.primitive, true}};
            }
        }
    }
}

TEST(AcceleratorSurface, TangentsOfTheFileComeFirst) {
    auto mesh = cube_with_coordinates();
    for (const Point<Object>& vertex : mesh->vertices) {
        (void)vertex;
        mesh->tangents.push_back({0.6f, 0.8f, 0.0f, -1.0f});
    }
    const Scene scene = scene_of(std::shared_ptr<const Mesh>(mesh), {});
    const Accelerator tree(scene, {false});
    const Ray down{{0.1, 0.2, 3.0}, {0, 0, -1}, {}};
    const Hit hit = tree.intersect(down);
    const PictureAxes axes = tree.picture_axes(hit, {0.1, 0.2, 0.5}, 0);
    EXPECT_LT(length(axes.right - Vec3{0.6, 0.8, 0.0}), kFloat);
    EXPECT_LT(length(axes.up - Vec3{0.8, -0.6, 0.0}), kFloat);  // −(z × right)
}

TEST(AcceleratorSurface, AnalyticShapesHaveTheirCharts) {
    const Scene scene = scene_of(Rectangle{2.0 * m, 4.0 * m}, {});
    const Accelerator tree(scene, {false});
    const Hit hit = tree.intersect({{0.5, 1.0, 3.0}, {0, 0, -1}, {}});
    const SurfaceCoordinates at = tree.coordinates(hit, {0.5, 1.0, 0.0});
    EXPECT_DOUBLE_EQ(at.uv[0].u, 0.75);
    EXPECT_DOUBLE_EQ(at.uv[1].v, 0.25);
    EXPECT_EQ(tree.picture_axes(hit, {0.5, 1.0, 0.0}, 0).up, (Vec3{0, 4, 0}));
    const Scene endless = scene_of(Plane{}, translation({0, 0, -1}));
    const Accelerator plane(endless, {false});
    const Hit below = plane.intersect({{2.5, 1.0, 3.0}, {0, 0, -1}, {}});
    EXPECT_DOUBLE_EQ(plane.coordinates(below, {2.5, 1.0, -1.0}).uv[0].u, 2.5);
}

TEST(AcceleratorSurface, AMeshWithoutCoordinatesHasNoAxes) {
    auto mesh = cube_with_coordinates();
    mesh->texcoords[1].clear();
    const Scene scene = scene_of(std::shared_ptr<const Mesh>(mesh), {});
    const Accelerator tree(scene, {false});
    const Hit hit = tree.intersect({{0.1, 0.2, 3.0}, {0, 0, -1}, {}});
    EXPECT_EQ(tree.picture_axes(hit, {0.1, 0.2, 0.5}, 0).right, Vec3{});
    EXPECT_EQ(tree.coordinates(hit, {0.1, 0.2, 0.5}).uv[0].u, 0.0);
}

}  // namespace
}  // namespace dewbow
