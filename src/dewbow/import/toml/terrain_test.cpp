// SPDX-License-Identifier: Apache-2.0

// Shapes of type "terrain", and instances that stand on them.

#include "dewbow/import/toml/terrain.h"

#include <gtest/gtest.h>

#include "dewbow/import/terrain/ground_height.h"
#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

#define GROUND                                                                        \
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = "    \
    "\"terrain\"\nname = \"hills\"\nmaterial = \"grey\"\nsize_m = 80\nheight_m = 9\n" \
    "cells = 16\n"
#define BALLS                                                                             \
    "[[shapes]]\ntype = \"sphere\"\nname = \"ball\"\nmaterial = \"grey\"\nradius_m = 1\n" \
    "group = \"balls\"\n[[instances]]\nof = \"balls\"\n"

Scene load(const std::string& text) { return parse_scene_toml("scene.toml", text).scene; }
std::string error(const std::string& text) {
    try {
        load(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(TerrainToml, AllKeysCount) {
    const Scene scene =
        load(GROUND
             "feature_m = 30\nroughness = 0.5\nseed = 7\nmiddle_finer = 3\nisland = "
             "true\nvalley = { azimuth_deg = 20, width_m = 5, depth = 0.5 }\ncolours "
             "= [[0, 0.1, 0.2], [1, 1, 1]]\nmottling = 0.2\n");
    Terrain same;
    same.size = 80.0 * unit::m, same.height = 9.0 * unit::m, same.feature = 30.0 * unit::m;
    same.roughness = 0.5, same.seed = 7, same.cells = 16, same.middle_finer = 3.0;
    same.island = true;
    same.valley = Valley{20.0 * unit::deg, 5.0 * unit::m, 0.5};
    same.colours = {{0.0f, 0.1f, 0.2f}, {1.0f, 1.0f, 1.0f}};
    same.mottling = 0.2;
    const auto expected = make_terrain(same);
    const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(scene.shapes.at(0).geometry);
    for (std::size_t i = 0; i < expected->vertices.size(); ++i)
        ASSERT_EQ(mesh.vertices[i].v, expected->vertices[i].v);
    EXPECT_EQ(mesh.colours, expected->colours);
}

TEST(TerrainToml, MistakesAreShown) {
    const struct {
        std::string text, expected;
    } kCases[] = {
        {GROUND "cells = 9", "cells"},
        {GROUND "roughness = 1.5", "roughness is 1.5; it must be between 0 and 1"},
        {GROUND "valey = { width_m = 5 }", "valley"},
        {GROUND "valley = { azimuth_deg = 5 }", "width"},
        {GROUND "colours = [[1, 1]]", "colours[0]"},
        {GROUND "colours = 1", "expected [[r, g, b], …]"},
        {GROUND "middle_finer = 0.5", "middle_finer"},
        {GROUND BALLS "on = \"hill\"", "hills"},
        {GROUND BALLS "on = \"hills\"\npositions = [[0, 0, 0], [99, 0, 0]]",
         "place 2 (x = 99, z = 0) is beside the ground"},
        {GROUND "[[shapes]]\ntype = \"plane\"\nname = \"floor\"\nmaterial = \"grey\"\n" BALLS
                "on = \"floor\"",
         "neither terrain nor a mesh"},
    };
    for (const auto& [text, expected] : kCases)
        EXPECT_NE(error(text).find(expected), std::string::npos) << text << "\n" << error(text);
}

TEST(TerrainToml, InstancesStandOnIt) {
    const Scene scene =
        load(GROUND BALLS "on = [\"hills\"]\npositions = [[3, 0, 4], [-20, 2.5, 11]]\n");
    const Shape* ground[] = {&scene.shapes.at(0)};
    const GroundHeight height(ground);
    const auto centre = [&](std::size_t i) {
        return scene.shapes.at(i).world_from_object(Point<Object>{}).v;
    };
    EXPECT_EQ(centre(1), (Vec3{3.0, *height.at(3.0, 4.0), 4.0}));
    EXPECT_EQ(centre(2), (Vec3{-20.0, *height.at(-20.0, 11.0) + 2.5, 11.0}));
    EXPECT_GT(*height.at(3.0, 4.0), 0.0);
}

}  // namespace
}  // namespace dewbow
