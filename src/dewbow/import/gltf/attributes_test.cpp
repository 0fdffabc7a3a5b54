// SPDX-License-Identifier: Apache-2.0

// What vertices have besides places, quantised numbers, morph targets and instances.

#include <gtest/gtest.h>

#include "dewbow/import/gltf/test_document.h"

namespace dewbow {
namespace {

using namespace gltf_test;

/// Numbers that are stored as floats.
constexpr double kFloat = 1e-6;

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, kFloat);
    EXPECT_NEAR(a.y, b.y, kFloat);
    EXPECT_NEAR(a.z, b.z, kFloat);
}

const Mesh& only_mesh(const ParsedScene& parsed) { return mesh_of(parsed.scene.shapes.at(0)); }

std::string attribute(const char* name, int accessor) {
    return R"("POSITION": 0, ")" + std::string(name) + R"(": )" + std::to_string(accessor);
}

const char* const kNormalised = R"(, "normalized": true)";

TEST(GltfAttributes, TextureCoordinatesOfAllTypes) {
    struct Type {
        std::string bytes;
        const char *component, *more;
        double scale;  ///< of the value 1, 2, … 6
    };
    const Type types[] = {
        {bytes_of<float>({1, 2, 3, 4, 5, 6}), "5126", "", 1.0},
        {bytes_of<std::uint8_t>({1, 2, 3, 4, 5, 6}), "5121", kNormalised, 1.0 / 255.0},
        {bytes_of<std::uint16_t>({1, 2, 3, 4, 5, 6}), "5123", kNormalised, 1.0 / 65535.0},
        {bytes_of<std::int8_t>({1, 2, 3, 4, 5, 6}), "5120", kNormalised, 1.0 / 127.0},
        {bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6}), "5122", kNormalised, 1.0 / 32767.0},
        {bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6}), "5122", "", 1.0},
    };
    for (const Type& type : types) {
        Buffer buffer;
        const int uv = buffer.add(type.bytes, type.component, 3, "VEC2", type.more);
        const ParsedScene parsed = parse(buffer.parts(attribute("TEXCOORD_1", uv)));
        const Mesh& mesh = only_mesh(parsed);
        EXPECT_TRUE(mesh.texcoords[0].empty());
        ASSERT_EQ(mesh.texcoords[1].size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(double(mesh.texcoords[1][i][0]), double(2 * i + 1) * type.scale, kFloat);
            EXPECT_NEAR(double(mesh.texcoords[1][i][1]), double(2 * i + 2) * type.scale, kFloat);
        }
    }
}

TEST(GltfAttributes, ColoursAreLinearAndHaveAnAlpha) {
    Buffer buffer;
    const int rgb = buffer.add(bytes_of<std::uint8_t>({255, 51, 0, 0, 0, 255, 0, 0, 0}), "5121", 3,
                               "VEC3", kNormalised);
    const int rgba = buffer.add(bytes_of<float>({0.5f, 2.0f, -1.0f, 0.25f, 0, 0, 0, 1, 0, 0, 0, 1}),
                                "5126", 3, "VEC4");
    const auto first = [&](int accessor) {
        return only_mesh(parse(buffer.parts(attribute("COLOR_0", accessor)))).colours.at(0);
    };
    EXPECT_EQ(first(rgb), (std::array<float, 4>{1.0f, 0.2f, 0.0f, 1.0f}));
    EXPECT_EQ(first(rgba), (std::array<float, 4>{0.5f, 1.0f, 0.0f, 0.25f}));  // clamped
}

TEST(GltfAttributes, TangentsKeepTheirHand) {
    Buffer buffer;
    const int tangents =
        buffer.add(bytes_of<std::int8_t>({127, 0, 0, -127, 0, 127, 0, 127, -127, 0, 0, 127}),
                   "5120", 3, "VEC4", kNormalised);
    const ParsedScene parsed = parse(buffer.parts(attribute("TANGENT", tangents)));
    const Mesh& mesh = only_mesh(parsed);
    EXPECT_EQ(mesh.tangents.at(0), (std::array<float, 4>{1, 0, 0, -1}));
    EXPECT_EQ(mesh.tangents.at(2), (std::array<float, 4>{-1, 0, 0, 1}));
}

TEST(GltfAttributes, QuantisedPlacesAndNormals) {
    Buffer buffer;
    // Elements of six bytes are eight apart.
    const int places =
        buffer.add(bytes_of<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 16384, 0}),
                   "5122", 3, "VEC3", kNormalised, R"(, "byteStride": 8)");
    const int whole = buffer.add(bytes_of<std::uint8_t>({0, 0, 0, 0, 200, 0, 0, 0, 0, 100, 7, 0}),
                                 "5121", 3, "VEC3", "", R"(, "byteStride": 4)");
    const int normals =
        buffer.add(bytes_of<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, -128, 0}), "5120", 3,
                   "VEC3", kNormalised, R"(, "byteStride": 4)");
    const auto mesh = [&](int p) {
        return only_mesh(parse(buffer.parts(R"("POSITION": )" + std::to_string(p) +
                                            R"(, "NORMAL": )" + std::to_string(normals))));
    };
    expect_near(mesh(places).vertices.at(1).v, {1, 0, 0});
    expect_near(mesh(places).vertices.at(2).v, {0, -1, 16384.0 / 32767.0});  // −32768 is −1 too
    expect_near(mesh(whole).vertices.at(2).v, {0, 100, 7});
    expect_near(mesh(whole).normals.at(2).v, {0, 0, -1});
}

TEST(GltfAttributes, SparseTextureCoordinates) {
    Buffer buffer;
    const int where = buffer.view(bytes_of<std::uint8_t>({1}));
    const int what = buffer.view(bytes_of<float>({0.25f, 0.75f}));
    const int uv =
        buffer.add(bytes_of<float>({0, 0, 0, 0, 0, 0}), "5126", 3, "VEC2",
                   R"(, "sparse": {"count": 1, "indices": {"componentType": 5121, "bufferView": )" +
                       std::to_string(where) + R"(}, "values": {"bufferView": )" +
                       std::to_string(what) + "}}");
    const ParsedScene parsed = parse(buffer.parts(attribute("TEXCOORD_0", uv)));
    EXPECT_EQ(only_mesh(parsed).texcoords[0].at(1), (std::array<float, 2>{0.25f, 0.75f}));
    EXPECT_EQ(only_mesh(parsed).texcoords[0].at(0), (std::array<float, 2>{0, 0}));
}

TEST(GltfAttributes, StayInStepWithTheVerticesThatAreUsed) {
    Buffer buffer;
    const int places = buffer.add(bytes_of<float>({9, 9, 9, 0, 0, 0, 8, 8, 8, 1, 0, 0, 0, 1, 0}),
                                  "5126", 5, "VEC3");
    const int uv = buffer.add(bytes_of<float>({9, 9, 1, 1, 8, 8, 3, 3, 4, 4}), "5126", 5, "VEC2");
    const int indices = buffer.add(bytes_of<std::uint16_t>({1, 3, 4}), "5123", 3, "SCALAR");
    const ParsedScene parsed = parse(buffer.parts(
        R"("POSITION": )" + std::to_string(places) + R"(, "TEXCOORD_0": )" + std::to_string(uv),
        R"(, "indices": )" + std::to_string(indices)));
    const Mesh& mesh = only_mesh(parsed);
    ASSERT_EQ(mesh.vertices.size(), 3u);
    expect_near(mesh.vertices[1].v, {1, 0, 0});
    EXPECT_EQ(mesh.texcoords[0].at(1), (std::array<float, 2>{3, 3}));
}

TEST(GltfAttributes, NumbersThatAreNoneDoNoHarm) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    Buffer buffer;
    const int all = buffer.add(bytes_of<float>({kNone, kNone, kNone, kNone, kNone, kNone, kNone,
                                                kNone, kNone, kNone, kNone, kNone}),
                               "5126", 3, "VEC4");
    const ParsedScene parsed =
        parse(buffer.parts(R"("POSITION": 0, "COLOR_0": )" + std::to_string(all) +
                           R"(, "TANGENT": )" + std::to_string(all)));
    EXPECT_EQ(only_mesh(parsed).colours.at(0), (std::array<float, 4>{0, 0, 0, 0}));
    EXPECT_EQ(only_mesh(parsed).tangents.at(0), (std::array<float, 4>{0, 0, 0, 1}));
}

TEST(GltfAttributes, CountsMustAgree) {
    for (const char* name : {"TEXCOORD_0", "TANGENT", "COLOR_0"}) {
        Buffer buffer;
        const bool pair = name[0] == 'T' && name[1] == 'E';
        const int two = buffer.add(std::string(32, '\0'), "5126", 2, pair ? "VEC2" : "VEC4");
        const std::string message = error_of(buffer.parts(attribute(name, two)));
        EXPECT_NE(message.find(std::string("/attributes/") + name + ": there are 2"),
                  std::string::npos)
            << message;
    }
}

// ---- morph targets -----------------------------------------------------------------------------

/// The triangle with two targets: its third corner up by 1, and all of it to the right by 10.
Parts with_targets(const std::string& mesh_weights, const std::string& node) {
    Buffer buffer;
    const int up = buffer.add(bytes_of<float>({0, 0, 0, 0, 0, 0, 0, 0, 1}), "5126", 3, "VEC3");
    const int right =
        buffer.add(bytes_of<float>({10, 0, 0, 10, 0, 0, 10, 0, 0}), "5126", 3, "VEC3");
    Parts parts =
        buffer.parts(R"("POSITION": 0)", R"(, "targets": [{"POSITION": )" + std::to_string(up) +
                                             R"(}, {"POSITION": )" + std::to_string(right) + "}]");
    parts.nodes = node;
    parts.primitive += "]" + mesh_weights + R"(}, {"primitives": [)" + parts.primitive;
    return parts;
}

TEST(GltfMorphs, WeightsOfTheMeshAndOfItsNode) {
    const ParsedScene at_rest = parse(with_targets("", R"([{"mesh": 0}])"));
    expect_near(only_mesh(at_rest).vertices.at(2).v, {0, 1, 0});
    const char* const weights = R"(, "weights": [0.5, 0.25])";
    const ParsedScene of_mesh = parse(with_targets(weights, R"([{"mesh": 0}])"));
    expect_near(only_mesh(of_mesh).vertices.at(2).v, {2.5, 1, 0.5});
    const ParsedScene of_node = parse(with_targets(weights, R"([{"mesh": 0, "weights": [1, 0]}])"));
    expect_near(only_mesh(of_node).vertices.at(2).v, {0, 1, 1});
    EXPECT_TRUE(of_node.diagnostics.empty());
}

TEST(GltfMorphs, OneMeshTakesSeveralShapes) {
    Parts parts = with_targets("", R"([{"mesh": 0, "weights": [1]}, {"mesh": 0}])");
    parts.roots = "[0, 1]";
    const ParsedScene parsed = parse(parts);
    expect_near(mesh_of(parsed.scene.shapes.at(0)).vertices.at(2).v, {0, 1, 1});
    expect_near(mesh_of(parsed.scene.shapes.at(1)).vertices.at(2).v, {0, 1, 0});
}

TEST(GltfMorphs, TargetsMustFit) {
    Buffer buffer;
    const int two = buffer.add(std::string(24, '\0'), "5126", 2, "VEC3");
    Parts parts = buffer.parts(R"("POSITION": 0)",
                               R"(, "targets": [{"POSITION": )" + std::to_string(two) + "}]");
    parts.nodes = R"([{"mesh": 0, "weights": [1]}])";
    EXPECT_NE(error_of(parts).find("/targets/0/POSITION: there are 2 displacements for 3 vertices"),
              std::string::npos)
        << error_of(parts);
}

// ---- instances, visibility ---------------------------------------------------------------------

TEST(GltfInstances, StandInTheFrameOfTheirNode) {
    Buffer buffer;
    const int places = buffer.add(bytes_of<float>({1, 0, 0, 0, 5, 0}), "5126", 2, "VEC3");
    const int turns = buffer.add(  // none, and 90 deg about z
        bytes_of<std::int16_t>({0, 0, 0, 32767, 0, 0, 23170, 23170}), "5122", 2, "VEC4",
        kNormalised);
    const int sizes = buffer.add(bytes_of<float>({1, 1, 1, 3, 3, 3}), "5126", 2, "VEC3");
    Parts parts = buffer.parts(R"("POSITION": 0)");
    parts.nodes =
        R"([{"name": "tree", "mesh": 0, "translation": [0, 0, 100], "extensions": {"EXT_mesh_gpu_instancing":
            {"attributes": {"TRANSLATION": )" +
        std::to_string(places) + R"(, "ROTATION": )" + std::to_string(turns) + R"(, "SCALE": )" +
        std::to_string(sizes) + "}}}}]";
    const ParsedScene parsed = parse(parts);
    ASSERT_EQ(parsed.scene.shapes.size(), 2u);
    EXPECT_EQ(parsed.scene.shapes[1].name, "tree 2");
    const auto corner = [&](std::size_t shape) {
        return parsed.scene.shapes[shape].world_from_object(Point<Object>{{1, 0, 0}}).v;
    };
    expect_near(corner(0), {2, 0, 100});
    expect_near(corner(1), {0, 8, 100});
    EXPECT_EQ(&mesh_of(parsed.scene.shapes[0]), &mesh_of(parsed.scene.shapes[1]));
    EXPECT_TRUE(parsed.diagnostics.empty());
}

TEST(GltfInstances, CountsMustAgree) {
    Buffer buffer;
    const int two = buffer.add(std::string(24, '\0'), "5126", 2, "VEC3");
    Parts parts = buffer.parts(R"("POSITION": 0)");
    parts.nodes =
        R"([{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0, "SCALE": )" +
        std::to_string(two) + "}}}}]";
    EXPECT_NE(error_of(parts).find("/SCALE: there are 2"), std::string::npos) << error_of(parts);
}

TEST(GltfNodes, HiddenOnesHideWhatIsBelow) {
    Parts parts;
    parts.nodes =
        R"([{"extensions": {"KHR_node_visibility": {"visible": false}}, "children": [1]}, {"mesh": 0}, {"mesh": 0}])";
    parts.roots = "[0, 2]";
    EXPECT_EQ(parse(parts).scene.shapes.size(), 1u);
}

}  // namespace
}  // namespace dewbow
