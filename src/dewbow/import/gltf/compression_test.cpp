// SPDX-License-Identifier: Apache-2.0

// Meshes and buffers that the libraries' own encoders packed; and the same, damaged.

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "dewbow/import/gltf/test_document.h"

namespace dewbow {
namespace {

using namespace gltf_test;

/// 14 bits over an extent of `kSide`: half of 1 / (2^14 − 1) of it.
constexpr double kSide = 8.0;
constexpr double kQuantisation = kSide / 16383.0;

// ---- EXT_meshopt_compression -------------------------------------------------------------------

std::string packed_vertices(const std::string& bytes, std::size_t stride) {
    const std::size_t count = bytes.size() / stride;
    std::string packed(meshopt_encodeVertexBufferBound(count, stride), '\0');
    packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()),
                                             packed.size(), bytes.data(), count, stride));
    return packed;
}

/// A document whose positions are packed.
Parts with_packed_positions(const std::string& packed, const std::string& more = "",
                            int count = 3) {
    Parts parts;
    parts.bytes = packed;
    parts.views = R"([{"buffer": 1, "byteLength": )" + std::to_string(12 * count) +
                  R"(, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteLength": )" +
                  std::to_string(packed.size()) + R"(, "byteStride": 12, "count": )" +
                  std::to_string(count) + R"(, "mode": "ATTRIBUTES")" + more + "}}}]";
    parts.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}])";
    parts.primitive = R"({"attributes": {"POSITION": 0}})";
    return parts;
}

const std::string kPositions = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0.25f});

TEST(GltfMeshopt, UnpacksAttributes) {
    Parts parts = with_packed_positions(packed_vertices(kPositions, 12));
    parts.rest = R"(, "extensionsRequired": ["EXT_meshopt_compression"])";
    const ParsedScene parsed = parse(parts);
    EXPECT_EQ(mesh_of(parsed.scene.shapes.at(0)).vertices.at(2).v, (Vec3{0, 1, 0.25}));
}

TEST(GltfMeshopt, UnpacksTriangles) {
    const std::uint32_t corners[] = {2, 0, 1};
    std::string packed(meshopt_encodeIndexBufferBound(3, 3), '\0');
    packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packed.data()),
                                            packed.size(), corners, 3));
    Buffer buffer;
    buffer.view(packed);
    Parts parts = buffer.parts(R"("POSITION": 0)", R"(, "indices": 1)");
    parts.views.pop_back();
    parts.views +=
        R"(, {"buffer": 0, "byteLength": 6, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": 36,
           "byteLength": )" +
        std::to_string(packed.size()) + R"(, "byteStride": 2, "count": 3, "mode": "TRIANGLES"}}}])";
    parts.accessors.pop_back();
    parts.accessors +=
        R"(, {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
    EXPECT_EQ(mesh_of(parse(parts).scene.shapes.at(0)).triangles.size(), 1u);
}

TEST(GltfMeshopt, AppliesFilters) {
    // 2^exponent times a mantissa of 24 bits: 2^-2 · 3 = 0.75, 2^0 · 1 = 1.
    constexpr std::uint32_t kThreeQuarters = (0xfeu << 24) | 3u, kOne = 1u;
    const std::string bytes = bytes_of<std::uint32_t>({0, 0, 0, kThreeQuarters, 0, 0, 0, kOne, 0});
    const ParsedScene parsed =
        parse(with_packed_positions(packed_vertices(bytes, 12), R"(, "filter": "EXPONENTIAL")"));
    EXPECT_EQ(mesh_of(parsed.scene.shapes.at(0)).vertices.at(1).v, (Vec3{0.75, 0, 0}));
}

TEST(GltfMeshopt, WhatTheDecodersTakeForGrantedIsChecked) {
    const std::string packed = packed_vertices(kPositions, 12);
    struct Row {
        const char *from, *to, *phrase;
    };
    const Row rows[] = {
        {R"("byteStride": 12)", R"("byteStride": 13)", "/byteStride: is no multiple of 4"},
        {R"("byteStride": 12)", R"("byteStride": 0)", "/byteStride: is no multiple of 4"},
        {R"("count": 3)", R"("count": 4)", "4 elements of 12 bytes are not the 36 bytes"},
        {"ATTRIBUTES", "PICTURES", "/mode: is none of ATTRIBUTES"},
        {"ATTRIBUTES", "TRIANGLES", "/byteStride: is neither 2 nor 4"},
        {R"("mode":)", R"("filter": "OCTAHEDRAL", "mode":)", "is neither 4 nor 8, as the filter"},
        {R"("mode":)", R"("filter": "SOFT", "mode":)", "the filter \"SOFT\" is not read"},
        {R"("buffer": 0)", R"("buffer": 5)", "/buffer: is 5"},
    };
    for (const Row& row : rows) {
        Parts parts = with_packed_positions(packed);
        const std::size_t extension = parts.views.find("EXT_meshopt");
        const std::size_t where = parts.views.find(row.from, extension);
        ASSERT_NE(where, std::string::npos) << row.from;
        parts.views.replace(where, std::string_view(row.from).size(), row.to);
        const std::string message = error_of(parts);
        EXPECT_NE(message.find(row.phrase), std::string::npos) << row.phrase << "\nis not in\n"
                                                               << message;
    }
    const std::string bomb = error_of(with_packed_positions(packed, "", 100'000'000));
    EXPECT_NE(bomb.find("bytes cannot hold 1200000000"), std::string::npos) << bomb;
}

TEST(GltfMeshopt, TruncationIsAnError) {
    const std::string packed = packed_vertices(kPositions, 12);
    for (std::size_t size = 0; size < packed.size(); ++size)
        EXPECT_NE(error_of(with_packed_positions(packed.substr(0, size))), "") << size;
}

// ---- KHR_draco_mesh_compression ----------------------------------------------------------------

/// A grid of 2 · kCells² triangles with places and texture coordinates.
std::string packed_grid(int method) {
    constexpr int kCells = 8;
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2 * kCells * kCells);
    const int place =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    std::uint32_t face = 0;
    const auto add = [&](std::array<std::array<int, 2>, 3> corners) {
        std::array<std::array<float, 3>, 3> p;
        std::array<std::array<float, 2>, 3> t;
        for (std::size_t i = 0; i < 3; ++i) {
            const float x = float(corners[i][0]), y = float(corners[i][1]);
            p[i] = {x, y, 0.25f * x};
            t[i] = {x / kCells, y / kCells};
        }
        const draco::FaceIndex index(face++);
        builder.SetAttributeValuesForFace(place, index, p[0].data(), p[1].data(), p[2].data());
        builder.SetAttributeValuesForFace(uv, index, t[0].data(), t[1].data(), t[2].data());
    };
    for (int y = 0; y < kCells; ++y) {
        for (int x = 0; x < kCells; ++x) {
            add({{{x, y}, {x + 1, y}, {x + 1, y + 1}}});
            add({{{x, y}, {x + 1, y + 1}, {x, y + 1}}});
        }
    }
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer out;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &out).ok());
    return std::string(out.data(), out.size());
}

Parts with_draco(const std::string& packed, const std::string& ids) {
    Parts parts;
    parts.bytes = packed;
    parts.views = R"([{"buffer": 0, "byteLength": )" + std::to_string(packed.size()) + "}]";
    parts.accessors = R"([{"componentType": 5126, "count": 81, "type": "VEC3"},
                          {"componentType": 5126, "count": 81, "type": "VEC2"},
                          {"componentType": 5123, "count": 384, "type": "SCALAR"}])";
    parts.primitive =
        R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "extensions":
            {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": )" +
        ids + "}}}";
    return parts;
}

const char* const kIds = R"({"POSITION": 0, "TEXCOORD_0": 1})";

TEST(GltfDraco, UnpacksBothWaysOfEncoding) {
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const ParsedScene parsed = parse(with_draco(packed_grid(method), kIds));
        const Mesh& mesh = mesh_of(parsed.scene.shapes.at(0));
        EXPECT_EQ(mesh.triangles.size(), 128u);
        ASSERT_EQ(mesh.vertices.size(), 81u);
        ASSERT_EQ(mesh.texcoords[0].size(), 81u);
        double area = 0.0;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 p = mesh.vertices[a].v;
            area += 0.5 * cross(mesh.vertices[b].v - p, mesh.vertices[c].v - p).z;
        }
        EXPECT_NEAR(area, kSide * kSide, 2.0 * kSide * kQuantisation);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const Vec3 p = mesh.vertices[i].v;
            EXPECT_NEAR(p.z, 0.25 * p.x, 2.0 * kQuantisation);
            EXPECT_NEAR(double(mesh.texcoords[0][i][0]), p.x / kSide, 1.0 / 4095.0);
        }
    }
}

TEST(GltfDraco, WrongOnesAreErrorsWithTheirPlace) {
    const std::string packed = packed_grid(draco::MESH_EDGEBREAKER_ENCODING);
    std::string version = packed, cloud = packed;
    version[5] = 1;
    cloud[7] = 0;
    struct Row {
        std::string packed;
        const char *ids, *phrase;
    };
    const std::string claims =  // 2^35 − 1 triangles in a few bytes
        packed.substr(0, 12) + std::string("\x10\xff\xff\xff\xff\x7f", 6);
    const Row rows[] = {
        {"no such thing", kIds, "cannot be read: it does not begin with \"DRACO\""},
        {version, kIds, "it is of Draco's version 1."},
        {cloud, kIds, "it holds no mesh"},
        {claims, kIds, "cannot hold 34359738367 triangles"},
        {packed.substr(0, packed.size() / 2), kIds, "its Draco stream is damaged"},
        {packed, R"({"POSITION": 7})", "/attributes/POSITION: the Draco stream has no attribute"},
        {packed, R"({"POSITION": 1})", "the Draco stream holds positions of 2 numbers"},
    };
    for (const Row& row : rows) {
        const std::string message = error_of(with_draco(row.packed, row.ids));
        EXPECT_NE(message.find(row.phrase), std::string::npos) << row.phrase << "\nis not in\n"
                                                               << message;
    }
}

// ---- damage ------------------------------------------------------------------------------------

/// Reads `make(packed)` with each byte of `packed` changed in several ways: whatever comes out, it
/// is a scene or an error.
template <class Make>
void read_damaged(const std::string& packed, Make make) {
    for (std::size_t i = 0; i < packed.size(); ++i) {
        for (const unsigned change : {0x01u, 0x80u, 0xffu}) {
            std::string damaged = packed;
            damaged[i] = char(static_cast<unsigned char>(damaged[i]) ^ change);
            error_of(make(damaged));
        }
    }
}

TEST(GltfDamage, MeshoptStreams) {
    read_damaged(packed_vertices(kPositions, 12),
                 [](const std::string& packed) { return with_packed_positions(packed); });
}

TEST(GltfDamage, DracoStreams) {
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
        read_damaged(packed_grid(method),
                     [](const std::string& packed) { return with_draco(packed, kIds); });
}

}  // namespace
}  // namespace dewbow
