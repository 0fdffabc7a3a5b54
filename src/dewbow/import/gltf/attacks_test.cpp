// SPDX-License-Identifier: Apache-2.0

// Files that are JSON but no honest glTF: all are refused, soon, with the place; none crashes or
// takes memory first.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dewbow/import/gltf/accessor.h"
#include "dewbow/import/gltf/test_document.h"
#include "dewbow/import/gltf/uri.h"

namespace dewbow {
namespace {

using namespace gltf_test;

TEST(GltfSlice, HoldsWhateverTheNumbers) {
    constexpr std::uint64_t kMax = ~std::uint64_t{0};
    const std::string bytes(100, 'x');
    using gltf::slice;
    EXPECT_TRUE(slice(bytes, 0, 12, 8, 12));   // 96 bytes
    EXPECT_FALSE(slice(bytes, 0, 12, 9, 12));  // 108
    EXPECT_TRUE(slice(bytes, 0, 16, 6, 12));   // 5 · 16 + 12 = 92
    EXPECT_TRUE(slice(bytes, 8, 16, 6, 12));   // just fits
    EXPECT_FALSE(slice(bytes, 9, 16, 6, 12));
    EXPECT_TRUE(slice(bytes, 100, 12, 0, 12));  // nothing, at the end
    EXPECT_FALSE(slice(bytes, 101, 12, 0, 12));
    EXPECT_FALSE(slice(bytes, kMax, 1, 1, 1));
    EXPECT_FALSE(slice(bytes, 0, kMax, 2, 1));
    EXPECT_FALSE(slice(bytes, 0, kMax, kMax, 1));
    EXPECT_FALSE(slice(bytes, 0, 1, 1, kMax));
    EXPECT_FALSE(slice(bytes, 1, 1, kMax, 1));                     // 1 + kMax wraps to 0
    EXPECT_FALSE(slice(bytes, 4, std::uint64_t{1} << 63, 3, 12));  // 2 · 2⁶³ wraps to 0
}

struct Attack {
    const char* name;
    void (*change)(Parts&);
    const char* phrase;
};

std::string deep_nodes(int depth) {
    std::string nodes = "[";
    for (int i = 0; i < depth; ++i) {
        nodes +=
            i + 1 < depth ? R"({"children": [)" + std::to_string(i + 1) + "]}," : R"({"mesh": 0}])";
    }
    return nodes;
}

const Attack kAttacks[] = {
    {"count beyond the view",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}])";
     },
     "/accessors/0: asks for 4 elements of 12 bytes, which do not lie inside /bufferViews/0 of 36"},
    {"count 2^62",
     [](Parts& p) {
         p.accessors =
             R"([{"bufferView": 0, "componentType": 5126, "count": 4611686018427387904, "type": "VEC3"}])";
     },
     "/accessors/0/count: is 4.611686018427388e+18"},
    {"count 2^53",
     [](Parts& p) {
         p.accessors =
             R"([{"bufferView": 0, "componentType": 5126, "count": 9007199254740992, "type": "VEC3"}])";
     },
     "do not lie inside"},
    {"count without bytes",
     [](Parts& p) {
         p.accessors = R"([{"componentType": 5126, "count": 100000000, "type": "VEC3"}])";
     },
     "has 100000000 elements but no bufferView"},
    {"negative count",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": -1, "type": "VEC3"}])";
     },
     "count: is -1"},
    {"fractional count",
     [](Parts& p) {
         p.accessors =
             R"([{"bufferView": 0, "componentType": 5126, "count": 2.5, "type": "VEC3"}])";
     },
     "count: is 2.5"},
    {"offset of the accessor",
     [](Parts& p) {
         p.accessors =
             R"([{"bufferView": 0, "byteOffset": 9007199254740991, "componentType": 5126, "count": 3, "type": "VEC3"}])";
     },
     "do not lie inside"},
    {"offset of the view",
     [](Parts& p) { p.views = R"([{"buffer": 0, "byteOffset": 9, "byteLength": 36}])"; },
     "/bufferViews/0: does not lie inside its buffer of 44"},
    {"length of the view", [](Parts& p) { p.views = R"([{"buffer": 0, "byteLength": 45}])"; },
     "/bufferViews/0: does not lie inside"},
    {"stride too small",
     [](Parts& p) { p.views = R"([{"buffer": 0, "byteLength": 36, "byteStride": 4}])"; },
     "/accessors/0: /bufferViews/0/byteStride is 4, less than the 12"},
    {"stride too large",
     [](Parts& p) { p.views = R"([{"buffer": 0, "byteLength": 36, "byteStride": 255}])"; },
     "byteStride: is 255"},
    {"stride beyond the view",
     [](Parts& p) { p.views = R"([{"buffer": 0, "byteLength": 36, "byteStride": 16}])"; },
     "do not lie inside"},
    {"no such view", [](Parts& p) { p.views = "[]"; },
     "/accessors/0/bufferView: there are no bufferViews"},
    {"no such accessor", [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 7}})"; },
     "POSITION: is 7; it must be a whole number between 0 and 1"},
    {"no such mesh", [](Parts& p) { p.nodes = R"([{"mesh": 1}])"; }, "/nodes/0/mesh: is 1"},
    {"no such material",
     [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 0}, "material": 1})"; },
     "/meshes/0/primitives/0/material: is 1"},
    {"index out of range", [](Parts& p) { p.bytes[40] = 3; },
     "/meshes/0/primitives/0/indices: uses vertex 3; there are 3, from 0"},
    {"indices that are floats",
     [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 0}, "indices": 0})"; },
     "/accessors/0/type: is VEC3; indices are SCALAR"},
    {"positions of 32-bit integers",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5125, "count": 3, "type": "VEC3"}])";
     },
     "/accessors/0/componentType: is no type of positions"},
    {"positions of two numbers",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"}])";
     },
     "/accessors/0/type: is VEC2; positions are VEC3"},
    {"sparse count",
     [](Parts& p) {
         p.accessors =
             R"([{"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 4}}])";
     },
     "/accessors/0/sparse/count: is 4"},
    {"sparse index out of range",
     [](Parts& p) {
         p.accessors =
             R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}, {"componentType": 5121, "count": 3, "type": "SCALAR",
            "sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 4, "componentType": 5125}, "values": {"bufferView": 1}}}])";
         p.bytes[40] = 9;
     },
     "/accessors/1/sparse: changes element 9 of 3"},
    {"buffer shorter than stated",
     [](Parts& p) { p.rest = R"(, "buffers": [{"byteLength": 45, "uri": "data:;base64,AAAA"}])"; },
     "/buffers/0: byteLength is 45, but there are 3 bytes"},
    {"cycle", [](Parts& p) { p.nodes = R"([{"children": [1]}, {"children": [0]}])"; },
     "/nodes/1/children/0: node 0 has two parents, or is its own"},
    {"own child", [](Parts& p) { p.nodes = R"([{"children": [0]}])"; }, "node 0 has two parents"},
    {"two parents",
     [](Parts& p) { p.nodes = R"([{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}])"; },
     "node 2 has two parents"},
    {"deep nodes", [](Parts& p) { p.nodes = deep_nodes(65); },
     "nodes are nested more than 64 deep"},
    {"transforms beyond double",
     [](Parts& p) {
         std::string nodes = "[";
         for (int i = 0; i < 40; ++i)
             nodes +=
                 R"({"scale": [1e12, 1e12, 1e12], "children": [)" + std::to_string(i + 1) + "]},";
         p.nodes = nodes + R"({"mesh": 0}])";
     },
     "is not finite"},
    {"infinite number",
     [](Parts& p) { p.nodes = R"([{"mesh": 0, "translation": [1e999, 0, 0]}])"; },
     "not JSON: number overflow"},
    {"huge number", [](Parts& p) { p.nodes = R"([{"mesh": 0, "translation": [1e300, 0, 0]}])"; },
     "/nodes/0/translation/0: is 1e+300"},
    {"zero quaternion", [](Parts& p) { p.nodes = R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])"; },
     "/nodes/0/rotation: is zero"},
    {"no affine matrix",
     [](Parts& p) { p.nodes = R"([{"mesh": 0, "matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])"; },
     "is not affine"},
    {"unknown required extension",
     [](Parts& p) {
         p.rest = R"(, "extensionsRequired": ["KHR_texture_transform", "MPEG_media"])";
     },
     "/extensionsRequired/1: the file cannot be read without the extension MPEG_media"},
    {"normals of another count",
     [](Parts& p) {
         p.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3"}])";
         p.primitive = R"({"attributes": {"POSITION": 0, "NORMAL": 1}})";
     },
     "NORMAL: there are 2 normals for 3 vertices"},
    {"address outside", [](Parts& p) { p.uri = "../secret.bin"; }, "/buffers/0/uri"},
    {"address outside, encoded", [](Parts& p) { p.uri = "%2e%2e/secret.bin"; }, "/buffers/0/uri"},
    {"absolute address", [](Parts& p) { p.uri = "/etc/passwd"; }, "/buffers/0/uri"},
    {"file scheme", [](Parts& p) { p.uri = "file:///etc/passwd"; }, "/buffers/0/uri"},
    {"NUL in an address", [](Parts& p) { p.uri = "a%00b"; }, "has a % that is not followed"},
    {"no base64", [](Parts& p) { p.uri = "data:;base64,A*AA"; },
     "is a data URI that is not valid base64"},
};

TEST(GltfAttacks, AreRefusedWithThePlace) {
    for (const Attack& attack : kAttacks) {
        Parts parts;
        attack.change(parts);
        const std::string message = error_of(parts);
        EXPECT_NE(message.find(attack.phrase), std::string::npos) << attack.name << ": " << message;
    }
}

TEST(GltfAttacks, SixtyFourNodesDeepIsTaken) {
    Parts parts;
    parts.nodes = deep_nodes(64);
    EXPECT_EQ(error_of(parts), "");
}

TEST(GltfAttacks, ManyNodesAreTaken) {
    Parts parts;
    parts.nodes = R"([{"mesh": 0})";
    parts.roots = "[0";
    for (int i = 1; i < 100'000; ++i) {
        parts.nodes += ",{}";
        parts.roots.append(",").append(std::to_string(i));
    }
    parts.nodes += "]";
    parts.roots += "]";
    EXPECT_EQ(parse(parts).scene.shapes.size(), 1u);
}

std::string error_of_bytes(const std::string& bytes) {
    try {
        parse_gltf("test.gltf", bytes);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(GltfJson, SyntaxErrorsHaveLineAndColumn) {
    EXPECT_TRUE(error_of_bytes("{\"a\": 1,\n  x}").starts_with("test.gltf:2:3: not JSON: "))
        << error_of_bytes("{\"a\": 1,\n  x}");
    EXPECT_TRUE(error_of_bytes("").starts_with("test.gltf:1:1: not JSON: ")) << error_of_bytes("");
    EXPECT_NE(error_of_bytes("[]").find("is an array of 0; expected an object"), std::string::npos);
    EXPECT_NE(error_of_bytes("{}").find("needs \"asset\""), std::string::npos);
    EXPECT_NE(
        error_of_bytes(R"({"asset": {"version": "1.0"}})").find("/asset/version: this is glTF 1.0"),
        std::string::npos);
}

TEST(GltfJson, NestingIsBounded) {
    const std::string bomb(1'000'000, '[');
    EXPECT_NE(error_of_bytes(bomb).find("nested more than 128 deep"), std::string::npos);
}

// ---- .glb --------------------------------------------------------------------------------------

std::string u32(std::uint32_t v) { return bytes_of<std::uint32_t>({v}); }

std::string chunk(std::string_view kind, std::string_view bytes) {
    std::string result = u32(std::uint32_t(bytes.size()));
    return result.append(kind).append(bytes);
}

std::string glb(std::string_view json, std::string_view binary) {
    const std::string body = chunk("JSON", json).append(chunk({"BIN\0", 4}, binary));
    std::string result = "glTF";
    return result.append(u32(2)).append(u32(std::uint32_t(body.size() + 12))).append(body);
}

/// The triangle of `Parts` with its bytes in the binary chunk.
std::string glb_of_triangle() {
    Parts parts;
    std::string json = text_of(parts);
    const std::size_t uri = json.find(R"(, "uri": "data:)");
    json.erase(uri, json.find('}', uri) - uri);
    return glb(json, parts.bytes);
}

TEST(Glb, HoldsTheBufferInItsSecondChunk) {
    EXPECT_EQ(parse_gltf("test.glb", glb_of_triangle()).scene.shapes.size(), 1u);
}

TEST(Glb, EveryTruncationIsAnError) {
    const std::string whole = glb_of_triangle();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(error_of_bytes(whole.substr(0, size)), "")
            << size << " of " << whole.size() << " bytes";
    }
}

TEST(Glb, ErrorsNameTheByte) {
    std::string file = glb_of_triangle();
    std::string version = file, length = file, chunk = file;
    version[4] = 1;
    EXPECT_NE(error_of_bytes(version).find("byte 0: this is version 1 of .glb"), std::string::npos);
    length[11] = 127;
    EXPECT_NE(error_of_bytes(length).find("the header states"), std::string::npos);
    chunk[15] = 127;
    EXPECT_NE(error_of_bytes(chunk).find("byte 12: a chunk states"), std::string::npos);
}

// ---- URIs --------------------------------------------------------------------------------------

TEST(GltfUri, Base64OfAllLengths) {
    for (const std::string bytes : {"", "a", "ab", "abc", "abcd", "\xff\x00\x7f"}) {
        EXPECT_EQ(gltf::decode_data_uri("data:x/y;base64," + base64(bytes)), bytes);
    }
    EXPECT_EQ(gltf::decode_data_uri("data:,text"), std::nullopt);
    EXPECT_EQ(gltf::decode_data_uri("data:;base64,A"), std::nullopt);
    EXPECT_EQ(gltf::decode_data_uri("data:,;base64,QUJD"), std::nullopt);
}

TEST(GltfUri, PercentSigns) {
    EXPECT_EQ(gltf::percent_decoded("a%20b%C3%a4"), "a b\xc3\xa4");
    for (const char* wrong : {"%", "%2", "%zz", "a%00"})
        EXPECT_EQ(gltf::percent_decoded(wrong), std::nullopt);
}

TEST(GltfUri, ExternalBuffersLieBesideTheFile) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "dewbow_gltf_uri";
    std::filesystem::create_directories(folder);
    Parts parts;
    std::ofstream(folder / "tri angle.bin", std::ios::binary) << parts.bytes;
    parts.uri = "tri%20angle.bin";
    EXPECT_EQ(parse_gltf(folder / "scene.gltf", text_of(parts)).scene.shapes.size(), 1u);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace dewbow
