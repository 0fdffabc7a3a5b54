// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <cmath>
#include <cstring>

#include "dewbow/base/file.h"

namespace dewbow::gltf {
namespace {

/// What the codecs can reach: an attribute byte that is the same in all of a block costs a bit in
/// 64, a triangle's three indices one byte.
constexpr std::uint64_t kMostExpansion = 1024;
constexpr std::uint64_t kFreeBytes = 1 << 16;

struct Packing {
    std::string mode, filter;
    std::uint64_t count = 0, stride = 0;
};

void require(bool holds, const Json& place, const char* sentence) {
    if (!holds) place.fail(sentence);
}

/// The rules of the extension, all of which the decoders take for granted.
Packing read_packing(const Json& json, std::size_t packed_bytes, std::uint64_t length) {
    Packing p;
    p.mode = json.require("mode").text();
    p.filter = json.text("filter", "NONE");
    p.count = json.require("count").whole(kMaxFileBytes);
    p.stride = json.require("byteStride").whole(256);
    const Json stride = json.require("byteStride");
    const bool attributes = p.mode == "ATTRIBUTES";
    require(attributes || p.mode == "TRIANGLES" || p.mode == "INDICES", json.require("mode"),
            "is none of ATTRIBUTES, TRIANGLES, INDICES");
    if (attributes) {
        require(p.stride > 0 && p.stride % 4 == 0, stride, "is no multiple of 4");
    } else {
        require(p.stride == 2 || p.stride == 4, stride, "is neither 2 nor 4, as indices have");
        require(p.filter == "NONE", json, "indices have no filter");
    }
    require(p.mode != "TRIANGLES" || p.count % 3 == 0, json.require("count"),
            "is no multiple of 3, as triangles have");
    if (p.filter == "OCTAHEDRAL")
        require(p.stride == 4 || p.stride == 8, stride, "is neither 4 nor 8, as the filter asks");
    else if (p.filter == "QUATERNION")
        require(p.stride == 8, stride, "is not 8, as the filter asks");
    else if (p.filter != "NONE" && p.filter != "EXPONENTIAL")
        json.require("filter").fail(fmt::format("the filter \"{}\" is not read", p.filter));
    if (p.count * p.stride != length) {
        json.fail(fmt::format("{} elements of {} bytes are not the {} bytes of the view", p.count,
                              p.stride, length));
    }
    if (length / kMostExpansion > packed_bytes + kFreeBytes / kMostExpansion)
        json.fail(fmt::format("{} bytes cannot hold {}", packed_bytes, length));
    return p;
}

bool decode(const Packing& p, std::string_view packed, char* to) {
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    if (p.mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(to, p.count, p.stride, from, packed.size()) == 0;
    if (p.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(to, p.count, p.stride, from, packed.size()) == 0;
    return meshopt_decodeIndexSequence(to, p.count, p.stride, from, packed.size()) == 0;
}

void apply_filter(const Packing& p, char* to) {
    // The library's SIMD code works on four elements at a time; so does its tail, on a copy.
    if (p.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(to, p.count, p.stride);
    if (p.filter == "QUATERNION") meshopt_decodeFilterQuat(to, p.count, p.stride);
    if (p.filter == "EXPONENTIAL") meshopt_decodeFilterExp(to, p.count, p.stride);
}

}  // namespace

std::string unpack_meshopt(const Json& compression, std::string_view packed, std::uint64_t length) {
    const Packing packing = read_packing(compression, packed.size(), length);
    std::string bytes(length, '\0');
    if (packing.count == 0) return bytes;
    if (!decode(packing, packed, bytes.data()))
        compression.fail("its bytes are damaged: they cannot be unpacked");
    apply_filter(packing, bytes.data());
    return bytes;
}

}  // namespace dewbow::gltf
