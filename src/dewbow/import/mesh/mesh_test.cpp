// SPDX-License-Identifier: Apache-2.0

// OBJ, PLY, STL as meshes; mtl_test.cpp has materials.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>

#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/mesh/obj.h"
#include "dewbow/import/mesh/ply.h"
#include "dewbow/import/mesh/stl.h"

namespace dewbow {
namespace {

Mesh obj(std::string_view text, Diagnostics* diagnostics = nullptr) {
    Diagnostics own;
    ObjModel model =
        parse_obj("test.obj", text, ObjDivision::none, diagnostics ? *diagnostics : own);
    return model.parts.empty() ? Mesh{} : model.parts.front().mesh;
}
Mesh ply(std::string_view text, Diagnostics* diagnostics = nullptr) {
    Diagnostics own;
    return parse_ply("test.ply", text, diagnostics ? *diagnostics : own);
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
        obj(std::string(kSquare) + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//2\n");
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
            "f 1 2 \\\n3\nusemtl b\nl 1 2\np 1\ncurv 0 1\ncurv 0 1\n",
        &diagnostics);
    ASSERT_EQ(diagnostics.size(), 2u);
    EXPECT_EQ(diagnostics[0].text, "lines and points are not shown");
    EXPECT_EQ(diagnostics[1].text, "statements \"curv\" are not used");
    EXPECT_EQ(diagnostics[1].place.line, 17u);
}

TEST(Obj, TextureCoordinatesAndColours) {
    Diagnostics diagnostics;
    const Mesh mesh =
        obj("v 0 0 0 1 0.5 0\nv 1 0 0 1 1 1\nv 0 1 0 2 0 0\nvt 0.25 0.75\nvt 1 0\nvt 0.5\n"
            "f 1/1 2/2 3/3\nf 1/2 2/2 3/3\n",
            &diagnostics);
    ASSERT_EQ(mesh.vertices.size(), 4u);  // the first is there with two coordinates
    ASSERT_EQ(mesh.texcoords[0].size(), 4u);
    EXPECT_EQ(mesh.texcoords[0][0], (std::array{0.25f, 0.25f}));  // downwards
    EXPECT_EQ(mesh.texcoords[0][1], (std::array{1.0f, 1.0f}));
    EXPECT_EQ(mesh.texcoords[0][2], (std::array{0.5f, 1.0f}));
    ASSERT_EQ(mesh.colours.size(), 4u);
    // sRGB's 0.5 is 0.2140 [IEC 61966-2-1].
    constexpr double kHalfTolerance = 1e-4;
    EXPECT_NEAR(double(mesh.colours[0][1]), 0.2140, kHalfTolerance);
    EXPECT_EQ(mesh.colours[2][0], 1.0f);  // 2 is too much
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].place.line, 3u);
}

std::vector<std::pair<std::string, std::size_t>> parts_of(const std::string& faces) {
    Diagnostics diagnostics;
    std::string text;
    for (int i = 0; i < 9; ++i)
        text += "v " + std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
    std::vector<std::pair<std::string, std::size_t>> parts;
    for (const ObjPart& part :
         parse_obj("test.obj", text + faces, ObjDivision::objects_and_materials, diagnostics).parts)
        parts.emplace_back(part.name + "/" + part.material, part.mesh.triangles.size());
    return parts;
}

TEST(Obj, ObjectsAndMaterialsDivideFaces) {
    using Parts = std::vector<std::pair<std::string, std::size_t>>;
    EXPECT_EQ(parts_of("o a\nf 1 2 3\no b\nusemtl x\nf 4 5 6\nusemtl y\nf 4 5 6\n"),
              (Parts{{"a/", 1}, {"b/x", 1}, {"b/y", 1}}));
    // An object that comes again goes on; groups within objects divide nothing.
    EXPECT_EQ(parts_of("o a\ng x\nf 1 2 3\no b\nf 4 5 6\no a\ng y\nf 3 2 1\n"),
              (Parts{{"a/", 2}, {"b/", 1}}));
    EXPECT_EQ(parts_of("g my left foot\nf 1 2 3\ng b\nf 4 5 6\n"),
              (Parts{{"my left foot/", 1}, {"b/", 1}}));
    // Groups of one material that touch are one body; of two materials they are two.
    EXPECT_EQ(parts_of("g a\nf 1 2 3\ng b\nf 4 5 6\ng c\nf 3 4 7\n"), (Parts{{"a/", 3}}));
    EXPECT_EQ(parts_of("g a\nusemtl x\nf 1 2 3\ng b\nusemtl y\nf 1 2 3\n"),
              (Parts{{"a/x", 1}, {"b/y", 1}}));
}

TEST(Obj, ManyUnknownStatementsAreNotedInFewLines) {
    std::string text = kSquare;
    for (int i = 0; i < 1000; ++i) text += "word" + std::to_string(i) + "\n";
    Diagnostics diagnostics;
    obj(text, &diagnostics);
    EXPECT_EQ(diagnostics.size(), 11u);
}

TEST(Obj, ErrorsNameTheLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"v 0 0 0\nv 1 x 0", "test.obj:2: \"x\" is no number"},
        {"v 0 0", "test.obj:1: \"v\" needs three numbers"},
        {"v 0 0 0\nf 1 2 3", "test.obj:2: there is no vertex 2: 1 stand above"},
        {"v 0 0 0\nf 0 1 1", "\"0\" is no index of a vertex"},
        {"v 0 0 0\nf -2 1 1", "there is no vertex -2"},
        {"v 0 0 0\nf 1//1 1//1 1//1", "there is no normal 1"},
        {"v 0 0 0\nf 1/1 1/1 1/1", "there is no texture coordinate 1"},
        {"v 0 0 0\nvt 0 y\n", "test.obj:2: \"y\" is no number"},
        {"vt\n", "\"vt\" needs one to three numbers"},
        {"v 0 0 0 1 red 1", "\"red\" is no number"},
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
        const Mesh mesh = ply(binary_ply(little));
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.vertices[1].v, (Vec3{1, 0, -3}));
        EXPECT_EQ(mesh.normals[2].v, (Vec3{0, 0, 1}));
        EXPECT_NEAR(measure(mesh).area, 0.5, 1e-15);
    }
}

TEST(Ply, EveryTruncationIsAnError) {
    const std::string whole = binary_ply(true);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(error_of([&] { ply(whole.substr(0, size)); }), "") << size;
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
        const std::string message = error_of([text = text] { ply(text); });
        EXPECT_NE(message.find(phrase), std::string::npos) << message << "\nin\n" << text;
    }
}

TEST(Ply, ElementsOfNothingCostNothing) {
    // 2⁶⁴ − 1 elements without properties are no bytes and no time.
    const std::string head =
        std::string("element void 18446744073709551615\n") + kVertices + kFaces;
    EXPECT_EQ(ply(ascii_ply(head.c_str(), "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).triangles.size(), 1u);
}

TEST(Ply, ColoursAndTextureCoordinates) {
    struct Case {
        const char* colours;
        const char* coordinates;
        const char* row;
    };
    // 188 is the byte of 0.5 as sRGB stores it: 0.5028; [IEC 61966-2-1] gives 187.5 for 0.5.
    constexpr double kHalfByte = 0.004;
    const Case cases[] = {
        {"property uchar red\nproperty uchar green\nproperty uchar blue\n",
         "property float s\nproperty float t\n", "188 255 0 0.25 0.75"},
        {"property float red\nproperty float green\nproperty float blue\n",
         "property float u\nproperty float v\n", "0.5 1 0 0.25 0.75"},
        {"property ushort red\nproperty ushort green\nproperty ushort blue\n",
         "property float texture_u\nproperty float texture_v\n", "48189 65535 0 0.25 0.75"},
    };
    for (const Case& c : cases) {
        std::string body;
        for (const char* place : {"0 0 0 ", "1 0 0 ", "0 1 0 "}) {
            body += place;
            body += c.row;
            body += "\n";
        }
        const Mesh mesh =
            ply(ascii_ply((std::string(kVertices) + c.colours + c.coordinates + kFaces).c_str(),
                          (body + "3 0 1 2\n").c_str()));
        ASSERT_EQ(mesh.colours.size(), 3u);
        EXPECT_NEAR(double(mesh.colours[1][0]), 0.5, kHalfByte);
        EXPECT_EQ(mesh.colours[1][1], 1.0f);
        EXPECT_EQ(mesh.colours[1][3], 1.0f);
        ASSERT_EQ(mesh.texcoords[0].size(), 3u);
        EXPECT_EQ(mesh.texcoords[0][2], (std::array{0.25f, 0.25f}));
    }
}

TEST(Ply, ColoursOutOfRangeAreHeldAndNoted) {
    Diagnostics diagnostics;
    const std::string head =
        std::string(kVertices) +
        "property float red\nproperty float green\nproperty float blue\nproperty uchar alpha\n" +
        kFaces;
    const Mesh mesh =
        ply(ascii_ply(head.c_str(), "0 0 0 2 0 nan 255\n1 0 0 -1 0 0 0\n0 1 0 0 0 0 51\n3 0 1 2\n"),
            &diagnostics);
    EXPECT_EQ(mesh.colours[0], (std::array{1.0f, 0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(mesh.colours[1], (std::array{0.0f, 0.0f, 0.0f, 0.0f}));
    EXPECT_EQ(mesh.colours[2][3], 0.2f);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_NE(diagnostics[0].text.find("3 colour values"), std::string::npos);
}

// ---- STL ---------------------------------------------------------------------------------------

Mesh stl(const std::string& bytes, Diagnostics* diagnostics = nullptr) {
    Diagnostics own;
    return parse_stl("test.stl", bytes, diagnostics ? *diagnostics : own);
}

/// Triangles of nine floats each, under a head of 80 bytes.
std::string binary_stl(const std::vector<std::array<float, 9>>& triangles, std::string head = {}) {
    head.resize(80, ' ');
    std::string file = head + binary(std::uint32_t(triangles.size()), true);
    for (const auto& triangle : triangles) {
        for (int i = 0; i < 3; ++i) file += binary(0.0f, true);
        for (const float value : triangle) file += binary(value, true);
        file += std::string(2, '\0');
    }
    return file;
}

constexpr std::array<float, 9> kOneTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
/// Shares an edge with it, one corner with the other sign of zero.
constexpr std::array<float, 9> kItsNeighbour{1, 0, 0, 1, 1, 0, -0.0f, 1, 0};
const char* const kTextFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
    "endfacet\n";

TEST(Stl, CornersAtOnePlaceAreOneVertex) {
    const Mesh mesh = stl(binary_stl({kOneTriangle, kItsNeighbour}));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(measure(mesh).triangles, 2u);
    EXPECT_EQ(measure(mesh).area, 1.0);
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, ABinaryFileMayBeginWithSolid) {
    EXPECT_EQ(stl(binary_stl({kOneTriangle}, "solid but binary")).triangles.size(), 1u);
}

TEST(Stl, TextMayHoldSeveralSolids) {
    const std::string solid = std::string("solid a name\n") + kTextFacet + "endsolid a name\r\n";
    EXPECT_EQ(stl(solid).triangles.size(), 1u);
    const Mesh two = stl(solid + solid);
    EXPECT_EQ(two.triangles.size(), 2u);
    EXPECT_EQ(two.vertices.size(), 3u);
}

TEST(Stl, BytesBehindTheLastTriangleAreNoted) {
    Diagnostics diagnostics;
    EXPECT_EQ(stl(binary_stl({kOneTriangle}) + "abc", &diagnostics).triangles.size(), 1u);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].text, "3 bytes after the last triangle are not used");
}

TEST(Stl, ErrorsSayWhatIsWrong) {
    const std::string whole = binary_stl({kOneTriangle});
    std::string absurd = whole;
    absurd.replace(80, 4, "\xff\xff\xff\xff");
    const std::pair<std::string, const char*> wrong[] = {
        {"", "0 bytes are too few for a binary STL file"},
        {std::string(83, 'x'), "83 bytes are too few"},
        {whole.substr(0, whole.size() - 1),
         "states 1 triangles, which take 134 bytes; the file has 133"},
        {absurd, "states 4294967295 triangles, which take 214748364834 bytes; the file has 134"},
        {std::string("solid\n") + kTextFacet, "test.stl:8: the file ends before \"endsolid\""},
        {"solid\nfacet\nvertex 0 0\n", "test.stl:3: \"vertex\" needs three numbers"},
        {"solid\nvertex 0 0 x\n", "\"x\" is no number"},
        {"solid\nvertex 0 0 0\nvertex 0 0 0\nendloop\n", "a facet has 2 corners"},
        {"solid\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nvertex 1 0 0\n", "a fourth corner"},
        {"solid\ntriangle\n", "unknown word \"triangle\""},
    };
    for (const auto& [bytes, phrase] : wrong) {
        const std::string message = error_of([bytes = bytes] { stl(bytes); });
        EXPECT_NE(message.find(phrase), std::string::npos) << message;
    }
}

// ---- files -------------------------------------------------------------------------------------

std::filesystem::path shared(const char* name) {
    return std::filesystem::path(DEWBOW_SHARED_DATA) / "mesh" / name;
}

/// Whether every edge is there as often in one direction as in the other.
bool is_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            balance[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return std::all_of(balance.begin(), balance.end(),
                       [](const auto& row) { return row.second == 0; });
}

TEST(MeshFiles, EveryFormatGivesTheSameClosedSolid) {
    const std::pair<const char*, double> files[] = {
        // as the maker of the files states them; the sphere has radius 0.5, and its chords cut off
        // less than the tolerance
        {"brilliant.obj", 0.21002},
        {"brilliant.ply", 0.21002},
        {"brilliant_binary.stl", 0.21002},
        {"prism60.obj", 0.649519},
        {"prism60.ply", 0.649519},
        {"prism60_ascii.stl", 0.649519},
        {"icosphere5.ply", 4.0 / 3.0 * std::numbers::pi * 0.125},
    };
    constexpr double kRelative = 2e-3;
    for (const auto& [name, volume] : files) {
        if (!std::filesystem::exists(shared(name))) GTEST_SKIP() << "no " << shared(name);
        Diagnostics diagnostics;
        const auto mesh = load_mesh(shared(name), diagnostics);
        EXPECT_TRUE(diagnostics.empty()) << name;
        EXPECT_TRUE(is_closed(*mesh)) << name;
        EXPECT_NEAR(measure(*mesh).volume, volume, volume * kRelative) << name;
    }
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
