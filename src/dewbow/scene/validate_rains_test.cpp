// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "dewbow/base/error.h"
#include "dewbow/scene/rain_inside.h"
#include "dewbow/scene/scene.h"
#include "dewbow/sky/test_drops.h"

namespace dewbow {
namespace {

using namespace unit;

const DropCloudPtr& some_drops() {
    static const DropCloudPtr drops = make_drop_cloud(test_drops(1e-3));
    return drops;
}

MeshRegion tetrahedron(std::size_t faces) {
    Mesh mesh;
    mesh.name = "tetra";
    mesh.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    mesh.triangles.resize(faces);
    return {std::make_shared<const Mesh>(std::move(mesh)),
            Transform<World, Object>(scaling({2, 2, 2}))};
}

std::string complaint(Rain rain, int orders = 1) {
    Scene scene = make_empty_scene();
    scene.render.rain.orders = orders;
    scene.rains.push_back(std::move(rain));
    try {
        validate(scene);
    } catch (const InputError& error) {
        return error.sentence();
    }
    return "";
}

TEST(ValidateRains, LetsGoodOnesPass) {
    EXPECT_EQ(complaint({"a", ConvexRegion::everywhere(), some_drops(), {}}), "");
    EXPECT_EQ(complaint({"a", ConvexRegion::layer(0.0 * m, 1.0 * m), some_drops(), Chaos{}}), "");
    EXPECT_EQ(complaint({"a", tetrahedron(4), some_drops(), {}}), "");
}

// Each flight in it would be lit undimmed, and so the sum over orders would grow with the depth.
TEST(ValidateRains, RainWithoutEndHasOneOrder) {
    for (const int orders : {2, RainSettings::kAllOrders}) {
        EXPECT_EQ(
            complaint({"a", ConvexRegion::everywhere(), some_drops(), {}}, orders),
            "rain \"a\": it has no end, so that light of all orders would come from "
            "everywhere; render.rain.orders above 1 needs a layer, a box, a curtain or a mesh");
        EXPECT_EQ(complaint({"a", ConvexRegion::layer(0.0 * m, 1.0 * m), some_drops(), {}}, orders),
                  "");
    }
}

TEST(ValidateRains, SaysWhatIsWrong) {
    EXPECT_EQ(
        complaint({"a", ConvexRegion::layer(3.0 * m, 1.0 * m), some_drops(), {}}),
        "rain \"a\": its region is empty: it is -2 m thick, from one face to the one across; it "
        "must be more than 0");
    EXPECT_EQ(complaint({"a", ConvexRegion::everywhere(), nullptr, {}}),
              "rain \"a\": its drops are missing");
    EXPECT_EQ(
        complaint({"a", tetrahedron(3), some_drops(), {}}),
        "rain \"a\": the mesh \"tetra\" is open, so that nothing is inside of it: 3 of its "
        "edges belong to one triangle only (or to an odd number), the first from (0, 0, 2) to "
        "(0, 2, 0); it must be a closed surface");
    Chaos chaos;
    chaos.lacunarity = 1.0;
    EXPECT_EQ(complaint({"a", ConvexRegion::everywhere(), some_drops(), chaos}),
              "rain \"a\": lacunarity of its chaos is 1; it must be between 1.1 and 10");
}

TEST(RainInside, AMeshStandsWhereItsTransformPutsIt) {
    const RainInside inside({"a", tetrahedron(4), nullptr, {}});
    const double third = 1.0 / 3.0;
    const Dir<World> diagonal{normalised({1, 1, 1})};
    // From the corner at the origin to the middle of the face x + y + z = 2.
    EXPECT_NEAR(inside.length_inside({{-1, -1, -1}}, diagonal, 10.0), 2.0 * std::sqrt(third),
                1e-14);
    EXPECT_NEAR(inside.length_inside({{0.2, 0.2, 0.2}}, diagonal, 0.5), 0.5, 1e-14);
}

}  // namespace
}  // namespace dewbow
