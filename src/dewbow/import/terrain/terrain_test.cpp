// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/terrain/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/import/terrain/ground_height.h"

namespace dewbow {
namespace {

/// Of some dozen operations on lengths of at most 1000 m.
constexpr double kRounding_m = 1e-9;

Terrain hills() {
    Terrain terrain;
    terrain.cells = 64;
    terrain.seed = 4;
    return terrain;
}

std::vector<double> heights(const Terrain& terrain) {
    const auto mesh = make_terrain(terrain);
    std::vector<double> y;
    for (const auto& vertex : mesh->vertices) y.push_back(vertex.v.y);
    return y;
}

TEST(Terrain, FillsItsSquareFromBottomToTop) {
    const auto mesh = make_terrain(hills());
    ASSERT_EQ(mesh->vertices.size(), 65u * 65u);
    EXPECT_EQ(mesh->triangles.size(), 2u * 64u * 64u);
    Vec3 low = mesh->vertices[0].v, high = low;
    for (const auto& vertex : mesh->vertices) low = min(low, vertex.v), high = max(high, vertex.v);
    EXPECT_EQ(low, (Vec3{-500.0, 0.0, -500.0}));
    EXPECT_EQ(high, (Vec3{500.0, 100.0, 500.0}));
    EXPECT_TRUE(mesh->colours.empty());
}

// The normal of a vertex lies among those of the triangles around it, which are front faces
// upwards.
TEST(Terrain, NormalsAndFrontFacesLookUp) {
    const auto mesh = make_terrain(hills());
    for (const auto& [a, b, c] : mesh->triangles) {
        const Vec3 corner = mesh->vertices[a].v;
        const Vec3 facet =
            normalised(cross(mesh->vertices[b].v - corner, mesh->vertices[c].v - corner));
        EXPECT_GT(facet.y, 0.0);
        EXPECT_GT(dot(facet, mesh->normals[a].v), 0.8);
        EXPECT_NEAR(length(mesh->normals[a].v), 1.0, kRounding_m);
    }
}

TEST(Terrain, FollowsItsSeedAlone) {
    Terrain other = hills();
    EXPECT_EQ(heights(hills()), heights(other));
    other.seed = 5;
    EXPECT_NE(heights(hills()), heights(other));
}

TEST(Terrain, AValleyMultipliesTheRelief) {
    Terrain terrain = hills();
    const auto without = make_terrain(terrain);
    // It leads north-east: x = −z is its line.
    terrain.valley = Valley{45.0 * unit::deg, 120.0 * unit::m, 0.75};
    const auto with = make_terrain(terrain);
    for (std::size_t i = 0; i < with->vertices.size(); ++i) {
        const Vec3 v = without->vertices[i].v;
        const double off = (v.x + v.z) / std::sqrt(2.0) / 120.0;
        EXPECT_NEAR(with->vertices[i].v.y, v.y * (1.0 - 0.75 * std::exp(-off * off)), kRounding_m);
    }
}

TEST(Terrain, AnIslandEndsOnTheGround) {
    Terrain terrain = hills();
    terrain.island = true;
    const auto mesh = make_terrain(terrain);
    double highest = 0.0;
    for (const auto& vertex : mesh->vertices) {
        highest = std::max(highest, vertex.v.y);
        if (std::hypot(vertex.v.x, vertex.v.z) >= 500.0) {
            EXPECT_EQ(vertex.v.y, 0.0);
        }
    }
    EXPECT_GT(highest, 20.0);
}

TEST(Terrain, CellsAreFinerInTheMiddle) {
    Terrain terrain = hills();
    terrain.middle_finer = 8.0;
    const auto mesh = make_terrain(terrain);
    const double even = 1000.0 / 64.0;
    EXPECT_NEAR(mesh->vertices[33].v.x - mesh->vertices[32].v.x, even / 8.0, even / 8.0 * 0.01);
    EXPECT_EQ(mesh->vertices[64].v.x, 500.0);
}

// Second differences along x grow with roughness: of octave k they go as 1.92^(k (1 + roughness)).
TEST(Terrain, RoughnessRoughens) {
    double before = 0.0;
    for (const double roughness : {0.0, 0.3, 0.6, 1.0}) {
        Terrain terrain = hills();
        terrain.roughness = roughness;
        const auto y = heights(terrain);
        double sum = 0.0;
        for (std::size_t i = 1; i + 1 < y.size(); ++i)
            if (i % 65 != 0 && i % 65 != 64) sum += std::abs(y[i - 1] - 2.0 * y[i] + y[i + 1]);
        EXPECT_GT(sum, 1.1 * before) << roughness;
        before = sum;
    }
}

TEST(Terrain, ColoursGoFromTheLowestToTheHighest) {
    Terrain terrain = hills();
    terrain.colours = {{0.1f, 0.2f, 0.3f}, {0.3f, 0.2f, 0.1f}};
    const auto mesh = make_terrain(terrain);
    ASSERT_EQ(mesh->colours.size(), mesh->vertices.size());
    for (std::size_t i = 0; i < mesh->colours.size(); ++i) {
        const double up = mesh->vertices[i].v.y / 100.0;
        EXPECT_NEAR(mesh->colours[i][0], 0.1 + 0.2 * up, 1e-6);  // floats
        EXPECT_NEAR(mesh->colours[i][2], 0.3 - 0.2 * up, 1e-6);
    }
    terrain.mottling = 0.5;
    EXPECT_NE(make_terrain(terrain)->colours, mesh->colours);
}

Shape placed(std::shared_ptr<const Mesh> mesh, const Affine& at) {
    Shape shape;
    shape.geometry = std::move(mesh);
    shape.world_from_object = Transform<World, Object>(at);
    return shape;
}

/// The highest of all triangles at (x, z), by solving for the point in each.
double highest_of_all(const Shape& shape, double x, double z) {
    const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(shape.geometry);
    double highest = -1e300;
    for (const auto& corners : mesh.triangles) {
        Vec3 p[3];
        for (int k = 0; k < 3; ++k)
            p[k] = shape.world_from_object(mesh.vertices[corners[std::size_t(k)]]).v;
        const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
        const double y = p[0].y - (normal.x * (x - p[0].x) + normal.z * (z - p[0].z)) / normal.y;
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
            const Vec3 side = p[(k + 1) % 3] - p[k];
            inside = inside && dot(cross(side, Vec3{x, y, z} - p[k]), normal) >= 0.0;
        }
        if (inside) highest = std::max(highest, y);
    }
    return highest;
}

TEST(GroundHeight, IsThatOfTheHighestTriangle) {
    Terrain terrain = hills();
    terrain.cells = 24;
    const Shape low = placed(make_terrain(terrain), Affine{});
    terrain.seed = 9;
    const Shape high =
        placed(make_terrain(terrain),
               translation({30.0, 5.0, -20.0}) * rotation({0.0, 1.0, 0.0}, 30.0 * unit::deg));
    const Shape* both[] = {&low, &high};
    const GroundHeight ground(both);
    for (int i = 0; i < 60; ++i) {
        const double x = -490.0 + 16.3 * i, z = 480.0 - 15.7 * i;
        const double expected = std::max(highest_of_all(low, x, z), highest_of_all(high, x, z));
        ASSERT_TRUE(ground.at(x, z));
        EXPECT_NEAR(*ground.at(x, z), expected, kRounding_m);
    }
}

TEST(GroundHeight, IsNowhereBesideTheGround) {
    const Shape shape = placed(make_terrain(hills()), Affine{});
    const Shape* one[] = {&shape};
    const GroundHeight ground(one);
    EXPECT_TRUE(ground.at(499.9, 0.0));
    EXPECT_TRUE(ground.at(0.0, 0.0));  // a vertex
    EXPECT_FALSE(ground.at(500.1, 0.0));
    EXPECT_FALSE(ground.at(0.0, -1e9));
    EXPECT_FALSE(GroundHeight({}).at(0.0, 0.0));
}

}  // namespace
}  // namespace dewbow
