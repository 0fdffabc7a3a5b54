// SPDX-License-Identifier: Apache-2.0

// Groups and where they are placed.

#include "dewbow/import/toml/instances.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

/// Of a handful of multiplications by numbers near 1, in double.
constexpr double kRounding = 1e-12;
/// Angle and scale of a place are floats.
constexpr double kFloatRounding = 1e-6;

#define MATERIALS                                                                       \
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[materials.red]\ntype = " \
    "\"diffuse\"\nreflectance = [1, 0, 0]\n"
#define BALL "[[shapes]]\ntype = \"sphere\"\nmaterial = \"grey\"\nradius_m = 1\n"

class InstancesTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_instances_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    Scene load(const std::string& text) const {
        return parse_scene_toml(folder_ / "scene.toml", MATERIALS + text).scene;
    }
    std::string error(const std::string& text) const {
        try {
            load(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
    std::filesystem::path folder_;
};

Vec3 origin_of(const Shape& shape) { return shape.world_from_object(Point<Object>{}).v; }

void expect_near(Vec3 a, Vec3 b, double tolerance = kRounding) {
    EXPECT_LT(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST_F(InstancesTest, AGroupIsSeenOnlyWhereItIsPlaced) {
    EXPECT_TRUE(load(BALL "group = \"ball\"\n").shapes.empty());
    const Scene scene = load(BALL
                             "group = \"ball\"\nposition = [1, 0, 0]\n"
                             "[[instances]]\nof = \"ball\"\nposition = [0, 0, 5]\n"
                             "[[instances]]\nof = \"ball\"\nrotate_y_deg = 90\nscale = 2\n"
                             "material = \"red\"\n");
    ASSERT_EQ(scene.shapes.size(), 2u);
    expect_near(origin_of(scene.shapes[0]), {1, 0, 5});
    expect_near(origin_of(scene.shapes[1]), {0, 0, -2});  // +x turns to −z about +y
    EXPECT_EQ(scene.shapes[0].material, 0);
    EXPECT_EQ(scene.shapes[1].material, 1);
}

TEST_F(InstancesTest, PositionsPlaceTheGroupAfterItsOwnPlacement) {
    const Scene scene = load(BALL
                             "group = \"ball\"\n[[instances]]\nof = \"ball\"\nscale = 0.5\n"
                             "position = [0, 1, 0]\npositions_cm = [[0, 0, 0], [100, 0, 0]]\n");
    ASSERT_EQ(scene.shapes.size(), 2u);
    expect_near(origin_of(scene.shapes[1]), {1, 1, 0});
    const Bounds bounds = bounds_of(scene.shapes[1]);
    EXPECT_NEAR(bounds.high.y - bounds.low.y, 1.0, kRounding);
}

TEST_F(InstancesTest, PlacesFromAFile) {
    write("places.csv", "x,y,z,rotate_y_deg,scale\n# trees\n1,2,3\n\n4; 5; 6; 90\r\n7 8\t9 0 2\n");
    const Scene scene = load(BALL
                             "group = \"ball\"\nposition = [1, 0, 0]\n"
                             "[[instances]]\nof = \"ball\"\nfile = \"places.csv\"\n");
    ASSERT_EQ(scene.shapes.size(), 3u);
    expect_near(origin_of(scene.shapes[0]), {2, 2, 3});
    expect_near(origin_of(scene.shapes[1]), {4, 5, 5}, kFloatRounding);
    expect_near(origin_of(scene.shapes[2]), {9, 8, 9});
}

TEST_F(InstancesTest, MeshesAreShared) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = load(
        "[[imports]]\nfile = \"a.obj\"\ngroup = \"a\"\n[[instances]]\nof = \"a\"\npositions = "
        "[[0, 0, 0], [1, 0, 0]]\n[[instances]]\nof = \"a\"\nscale = [-1, 1, 1]\npositions = "
        "[[0, 0, 0], [1, 0, 0]]\n");
    ASSERT_EQ(scene.shapes.size(), 4u);
    const auto mesh = [&](std::size_t i) {
        return std::get<std::shared_ptr<const Mesh>>(scene.shapes[i].geometry);
    };
    EXPECT_EQ(mesh(0), mesh(1));
    EXPECT_NE(mesh(0), mesh(2));
    EXPECT_EQ(mesh(2), mesh(3));  // one mirrored copy for all mirror images
}

TEST_F(InstancesTest, GroupsMayHoldInstances) {
    const Scene scene = load(BALL
                             "group = \"ball\"\n"
                             "[[instances]]\nof = \"row\"\npositions = [[0, 0, 0], [0, 0, 9]]\n"
                             "[[instances]]\nof = \"ball\"\ngroup = \"row\"\npositions = [[1, 0, "
                             "0], [2, 0, 0], [3, 0, 0]]\n");
    ASSERT_EQ(scene.shapes.size(), 6u);
    expect_near(origin_of(scene.shapes[5]), {3, 0, 9});
}

TEST_F(InstancesTest, ErrorsNameThePlace) {
    write("wrong.csv", "1,2,3\n1,2,x\n");
    write("short.csv", "1,2\n");
    write("long.csv", "1,2,3,4,5,6\n");
    write("zero.csv", "1,2,3,0,0\n");
    write("none.csv", "# nothing\n");
    write("nan.csv", "nan,2,3\n");
    const std::string ball = BALL "group = \"ball\"\n";
    const std::string of = ball + "[[instances]]\nof = \"ball\"\n";
    const std::pair<std::string, const char*> wrong[] = {
        {ball + "[[instances]]\nof = \"bal\"\n", "scene.toml:13:6: there is no group \"bal\""},
        {ball + "[[instances]]\nof = \"bal\"\n", "did you mean \"ball\"?"},
        {"[[instances]]\nof = \"x\"\n", "shapes and imports with group = \"x\" make one"},
        {ball + "[[instances]]\nposition = [0, 0, 0]\n", "instance 1 needs of"},
        {ball + "[[instances]]\nof = \"a\"\ngroup = \"a\"\n", "the group \"a\" contains itself"},
        {ball + "[[instances]]\nof = \"a\"\ngroup = \"b\"\n[[instances]]\nof = \"b\"\ngroup = "
                "\"a\"\n",
         "contains itself"},
        {of + "material = \"gray\"\n", "did you mean \"grey\"?"},
        {of + "positions = []\n", "positions is an array of 0; expected [[x, y, z], …]"},
        {of + "positions = [[1, 2]]\n", "positions[0] is an array of 2"},
        {of + "positions = [[0, 0, 0]]\nfile = \"wrong.csv\"\n", "has both positions and file"},
        {of + "file = \"gone.csv\"\n", "gone.csv: cannot read"},
        {of + "file = \"wrong.csv\"\n", "wrong.csv:2: \"x\" is no number"},
        {of + "file = \"short.csv\"\n", "there are 2 numbers of at least 3"},
        {of + "file = \"long.csv\"\n", "there are more than five numbers"},
        {of + "file = \"zero.csv\"\n", "scale is 0; it must be between 1e-09 and 1000000000"},
        {of + "file = \"none.csv\"\n", "holds no place"},
        {of + "file = \"nan.csv\"\n", "x is nan; it must be between"},
        {BALL "group = \"\"\n", "group is empty; it must be a name"},
        {BALL "group = 3\n", "group is the number 3; expected a string"},
    };
    for (const auto& [text, phrase] : wrong)
        EXPECT_NE(error(text).find(phrase), std::string::npos) << text << "\n" << error(text);
}

TEST_F(InstancesTest, ABombOfGroupsIsRefusedBeforeItIsMade) {
    // Ten instances of ten of ten…: 10⁹ balls.
    std::string text = BALL "group = \"g0\"\n";
    std::string places = "[[0, 0, 0]";
    for (int i = 1; i < 10; ++i) places += ", [" + std::to_string(i) + ", 0, 0]";
    for (int i = 1; i <= 9; ++i)
        text += "[[instances]]\nof = \"g" + std::to_string(i - 1) + "\"\ngroup = \"g" +
                std::to_string(i) + "\"\npositions = " + places + "]\n";
    EXPECT_NE(error(text + "[[instances]]\nof = \"g9\"\n").find("20000000 are possible"),
              std::string::npos);
}

}  // namespace
}  // namespace dewbow
