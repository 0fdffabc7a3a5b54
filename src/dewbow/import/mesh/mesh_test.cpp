// SPDX-License-Identifier: Apache-2.0

// OBJ and PLY.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/mesh/obj.h"
#include "dewbow/import/mesh/ply.h"

namespace dewbow {
namespace {

Mesh obj(std::string_view text, Diagnostics* diagnostics = nullptr) {
    Diagnostics own;
    return parse_obj("test.obj", text, diagnostics ? *diagnostics : own);
}

template <class Parse>
std::string error_of(Parse parse) {
    try {
        parse();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Six times the volume that the triangles enclose, and their number and area, which no renumbering
/// changes.
struct Measure {
    std::size_t triangles = 0;
    double area = 0.0, volume = 0.0;
};
Measure measure(const Mesh& mesh) {
    Measure sum;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]].v, b = mesh.vertices[t[1]].v, c = mesh.vertices[t[2]].v;
        ++sum.triangles;
        sum.area += 0.5 * length(cross(b - a, c - a));
        sum.volume += dot(a, cross(b, c)) / 6.0;
    }
    return sum;
}

TEST(Obj, PolygonsAndNegativeIndices) {
    const Mesh positive = obj(std::string(kSquare) + "f 1 2 3 4\n");
    const Mesh negative = obj(std::string(kSquare) + "f -4 -3 -2 -1");
    for (const Mesh& mesh : {positive, negative}) {
        EXPECT_EQ(mesh.vertices.size(), 4u);
        EXPECT_EQ(measure(mesh).triangles, 2u);
        EXPECT_NEAR(measure(mesh).area, 1.0, 1e-15);
        EXPECT_TRUE(mesh.normals.empty());
    }
}

TEST(Obj, CornersWithOtherNormalsSplitTheVertex) {
    const Mesh mesh =
        obj(std::string(kSquare) + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1/9/2 3//1 4//2\n");
    ASSERT_EQ(mesh.vertices.size(), 5u);  // 1 is there twice, 3 once
    ASSERT_EQ(mesh.normals.size(), 5u);
    const std::uint32_t first = mesh.triangles[0][0], again = mesh.triangles[1][0];
    EXPECT_EQ(mesh.vertices[first].v, mesh.vertices[again].v);
    EXPECT_EQ(mesh.normals[first].v, (Vec3{0, 0, 1}));
    EXPECT_EQ(mesh.normals[again].v, (Vec3{0, 1, 0}));
    EXPECT_EQ(mesh.triangles[0][2], mesh.triangles[1][1]);
}

TEST(Obj, NormalsAreForAllCornersOrNone) {
    Diagnostics diagnostics;
    const Mesh mesh =
        obj(std::string(kSquare) + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n", &diagnostics);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_EQ(mesh.vertices.size(), 4u);
    ASSERT_EQ(diagnostics.size(), 1u);
}

TEST(Obj, WordsThatChangeThePictureAreNotedOnce) {
    Diagnostics diagnostics;
    obj(std::string("# hello\nmtllib x.mtl\r\no name\ng a\ns 1\nvt 0 0\nusemtl a\n") + kSquare +
            "f 1 2 \\\n3\nusemtl b\nl 1 2\ncurv 0 1\n",
        &diagnostics);
    ASSERT_EQ(diagnostics.size(), 3u);
    EXPECT_EQ(diagnostics[0].place.line, 2u);
    EXPECT_EQ(diagnostics[1].text, "lines and points are not shown");
    EXPECT_EQ(diagnostics[2].text, "statements \"curv\" are not used");
}

TEST(Obj, ErrorsNameTheLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"v 0 0 0\nv 1 x 0", "test.obj:2: \"x\" is no number"},
        {"v 0 0", "test.obj:1: \"v\" needs three numbers"},
        {"v 0 0 0\nf 1 2 3", "test.obj:2: there is no vertex 2: 1 stand above"},
        {"v 0 0 0\nf 0 1 1", "\"0\" is no index of a vertex"},
        {"v 0 0 0\nf -2 1 1", "there is no vertex -2"},
        {"v 0 0 0\nf 1//1 1//1 1//1", "there is no normal 1"},
        {"v 0 0 0\nf 1 1", "a face needs three corners"},
        {"v 0 0 0\nf 99999999999999999999 1 1", "is no index"},
        {"v 1,5 0 0", "\"1,5\" is no number"},
        {"v 0x1p3 0 0", "\"0x1p3\" is no number"},
    };
    for (const auto& [text, phrase] : wrong) {
        const std::string message = error_of([text = text] { obj(text); });
        EXPECT_NE(message.find(phrase), std::string::npos) << message;
    }
}

TEST(CleanMesh, DropsWhatCannotBeSeenAndCountsIt) {
    Mesh mesh =
        obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 2 0 0\nv 9 9 9\nv inf 0 0\n"
            "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\nf 1 2 7\n");
    const MeshRepairs repairs = clean(mesh);
    EXPECT_EQ(repairs.bad_vertex_triangles, 2u);
    EXPECT_EQ(repairs.flat_triangles, 2u);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.vertices.size(), 3u);  // unused ones are gone: they would spoil the bounds
}

TEST(CleanMesh, WhatBelongsToAVertexGoesWithIt) {
    Mesh mesh;
    mesh.vertices = {{{9, 9, 9}}, {{0, 0, 0}}, {{8, 8, 8}}, {{1, 0, 0}}, {{0, 1, 0}}};
    mesh.triangles = {{1, 3, 4}};
    for (std::uint32_t i = 0; i < 5; ++i) {
        mesh.texcoords[1].push_back({float(i), 0.0f});
        mesh.colours.push_back({float(i), 0.0f, 0.0f, 1.0f});
        mesh.tangents.push_back({float(i), 0.0f, 0.0f, 1.0f});
    }
    clean(mesh);
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_TRUE(mesh.texcoords[0].empty());
    constexpr float kOldIndices[] = {1, 3, 4};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.texcoords[1][i][0], kOldIndices[i]);
        EXPECT_EQ(mesh.colours[i][0], kOldIndices[i]);
        EXPECT_EQ(mesh.tangents[i][0], kOldIndices[i]);
    }
}

TEST(Mirrors, TheBitangentIsMirroredToo) {
    auto mesh = std::make_shared<Mesh>(obj(std::string(kSquare) + "f 1 2 3\n"));
    mesh->normals.assign(3, {normalised({1, 2, 3})});
    const Vec3 t = normalised(cross({0, 1, 1}, mesh->normals[0].v));
    mesh->tangents.assign(3, {float(t.x), float(t.y), float(t.z), 1.0f});
    const auto bitangent = [](const Mesh& m) {
        const auto& v = m.tangents[0];
        return cross(m.normals[0].v, {double(v[0]), double(v[1]), double(v[2])}) * double(v[3]);
    };
    Shape shape;
    shape.geometry = std::shared_ptr<const Mesh>(mesh);
    shape.world_from_object = Transform<World, Object>(scaling({-1, 1, 1}));
    const Shape upright = Mirrors().upright(shape);
    const Mesh& turned = *std::get<std::shared_ptr<const Mesh>>(upright.geometry);
    const Vec3 before = shape.world_from_object.affine().apply_linear(bitangent(*mesh));
    const Vec3 after = upright.world_from_object.affine().apply_linear(bitangent(turned));
    EXPECT_LT(length(before - after), 1e-6);  // rounding of tangents to float
}

// ---- PLY ---------------------------------------------------------------------------------------

/// `value` as PLY writes it in that order of bytes.
template <class T>
std::string binary(T value, bool little) {
    std::string raw(sizeof(T), '\0');
    std::memcpy(raw.data(), &value, sizeof(T));
    if (!little) std::reverse(raw.begin(), raw.end());
    return raw;
}

/// A triangle with normals, a colour that nobody wants, a list before the vertices, and odd types.
std::string binary_ply(bool little) {
    std::string file = std::string("ply\nformat binary_") + (little ? "little" : "big") +
                       "_endian 1.0\ncomment x\nelement camera 1\nproperty list uchar short ids\n"
                       "element vertex 3\nproperty uchar red\nproperty double x\nproperty float y\n"
                       "property short z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                       "element face 1\nproperty list ushort uint vertex_index\nend_header\n";
    file += binary<std::uint8_t>(2, little) + binary<std::int16_t>(7, little) +
            binary<std::int16_t>(8, little);
    for (int i = 0; i < 3; ++i) {
        file += binary<std::uint8_t>(200, little) + binary<double>(i == 1, little) +
                binary<float>(i == 2, little) + binary<std::int16_t>(-3, little);
        file += binary<float>(0, little) + binary<float>(0, little) + binary<float>(1, little);
    }
    file += binary<std::uint16_t>(3, little);
    for (std::uint32_t i = 0; i < 3; ++i) file += binary<std::uint32_t>(i, little);
    return file;
}

TEST(Ply, BothOrdersOfBytes) {
    for (const bool little : {true, false}) {
        const Mesh mesh = parse_ply("test.ply", binary_ply(little));
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.vertices[1].v, (Vec3{1, 0, -3}));
        EXPECT_EQ(mesh.normals[2].v, (Vec3{0, 0, 1}));
        EXPECT_NEAR(measure(mesh).area, 0.5, 1e-15);
    }
}

TEST(Ply, EveryTruncationIsAnError) {
    const std::string whole = binary_ply(true);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(error_of([&] { parse_ply("test.ply", whole.substr(0, size)); }), "") << size;
    }
}

std::string ascii_ply(const char* elements, const char* body) {
    return std::string("ply\nformat ascii 1.0\n") + elements + "end_header\n" + body;
}
const char* const kVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const char* const kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

TEST(Ply, ErrorsNameThePlace) {
    const std::string head = std::string(kVertices) + kFaces;
    const std::pair<std::string, const char*> wrong[] = {
        {"plx\n", "test.ply:1: the file does not begin with \"ply\""},
        {"ply\nformat ascii 2.0\nend_header\n", "test.ply:2: unknown format"},
        {"ply\nend_header\n", "the header states no format"},
        {"ply\nformat ascii 1.0\n", "the header has no end_header"},
        {ascii_ply("element vertex x\n", ""), "test.ply:3: expected: element NAME COUNT"},
        {ascii_ply("element vertex 1\nproperty real x\n", ""), "unknown type \"real\""},
        {ascii_ply("property float x\n", ""), "a property needs an element"},
        {ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"),
         "test.ply:12: \"x\" is no number"},
        {ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
         "face 1 uses vertex 3; there are 3, from 0"},
        {ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "uses vertex -1"},
        {ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n200 0 1 1\n"),
         "a list of 200 numbers does not fit"},
        {ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), "the file ends before"},
        {ascii_ply("element vertex 18446744073709551615\nproperty float x\nproperty float "
                   "y\nproperty float z\n",
                   "0 0 0\n"),
         "there cannot be 18446744073709551615 elements \"vertex\": 6 bytes are left"},
        {ascii_ply(kVertices, "0 0 0\n1 0 0\n0 1 0\n"), "has no faces"},
        {ascii_ply("element vertex 1\nproperty float x\n", "0\n"), "vertices have no property y"},
    };
    for (const auto& [text, phrase] : wrong) {
        const std::string message = error_of([text = text] { parse_ply("test.ply", text); });
        EXPECT_NE(message.find(phrase), std::string::npos) << message << "\nin\n" << text;
    }
}

TEST(Ply, ElementsOfNothingCostNothing) {
    // 2⁶⁴ − 1 elements without properties are no bytes and no time.
    const std::string head =
        std::string("element void 18446744073709551615\n") + kVertices + kFaces;
    EXPECT_EQ(parse_ply("test.ply", ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
                  .triangles.size(),
              1u);
}

// ---- files -------------------------------------------------------------------------------------

std::filesystem::path shared(const char* name) {
    return std::filesystem::path(DEWBOW_SHARED_DATA) / "mesh" / name;
}

TEST(MeshFiles, ABrilliantIsTheSameInBothFormats) {
    if (!std::filesystem::exists(shared("brilliant.obj")))
        GTEST_SKIP() << "no " << shared("brilliant.obj");
    Diagnostics diagnostics;
    const auto a = load_mesh(shared("brilliant.obj"), diagnostics);
    const auto b = load_mesh(shared("brilliant.ply"), diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    ASSERT_EQ(a->triangles.size(), b->triangles.size());
    EXPECT_EQ(a->triangles.size(), 334u);
    for (std::size_t i = 0; i < a->triangles.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3 va = a->vertices[a->triangles[i][c]].v,
                       vb = b->vertices[b->triangles[i][c]].v;
            EXPECT_LT(length(va - vb), 1e-6)
                << "triangle " << i;  // both files round to 7 to 9 digits
        }
    }
    EXPECT_NEAR(measure(*a).volume, 0.21002, 1e-5);
    EXPECT_NEAR(measure(*b).volume, 0.21002, 1e-5);
}

TEST(MeshFiles, APrismHasItsVolume) {
    if (!std::filesystem::exists(shared("prism60.ply")))
        GTEST_SKIP() << "no " << shared("prism60.ply");
    Diagnostics diagnostics;
    for (const char* name : {"prism60.obj", "prism60.ply"}) {
        const auto mesh = load_mesh(shared(name), diagnostics);
        EXPECT_NEAR(measure(*mesh).volume, 0.649519, 1e-6);
        EXPECT_EQ(mesh->triangles.size(), 8u);
    }
}

}  // namespace
}  // namespace dewbow
