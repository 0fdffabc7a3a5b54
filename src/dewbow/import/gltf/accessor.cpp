// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/accessor.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "dewbow/base/file.h"

namespace dewbow::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

constexpr std::uint64_t kMost = std::uint64_t{1} << 53;
constexpr std::uint64_t kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125,
                        kFloat = 5126;
constexpr std::uint64_t kMaxStride = 252;

std::uint64_t whole(const Json& object, std::string_view key, std::uint64_t otherwise) {
    const auto member = object.find(key);
    return member ? member->whole(kMost) : otherwise;
}

/// Bytes of a component that holds an index; 0 for other types.
std::uint64_t index_bytes(std::uint64_t component_type) {
    switch (component_type) {
        case kUnsignedByte:
            return 1;
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
            return 4;
        default:
            return 0;
    }
}

std::uint32_t index_at(const Slice& indices, std::uint64_t i, std::uint64_t bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, indices.first + i * indices.stride, bytes);
    return value;
}

Vec3 vec3_at(const Slice& values, std::uint64_t i) {
    float v[3];
    std::memcpy(v, values.first + i * values.stride, sizeof v);
    return {double(v[0]), double(v[1]), double(v[2])};
}

/// The elements that `reference` (an accessor, or a part of its `sparse`) finds in its buffer view.
Slice slice_of(Document& document, const Json& reference, std::uint64_t count,
               std::uint64_t element_bytes) {
    const Json view = document.item("bufferViews", reference.require("bufferView"));
    const std::string_view buffer = document.buffer(view.require("buffer"));
    const std::uint64_t view_length = view.require("byteLength").whole(kMost);
    const auto view_bytes = slice(buffer, whole(view, "byteOffset", 0), 1, view_length, 1);
    if (!view_bytes) {
        view.fail(fmt::format("does not lie inside its buffer of {} bytes", buffer.size()));
    }
    const auto stride = view.find("byteStride");
    // Old writers say 0 where elements follow each other.
    const std::uint64_t stated = stride ? stride->whole(kMaxStride) : 0;
    const std::uint64_t step = stated > 0 ? stated : element_bytes;
    if (step < element_bytes) {
        stride->fail(
            fmt::format("is {}, less than the {} bytes of an element", step, element_bytes));
    }
    const auto elements = slice({view_bytes->first, view_length}, whole(reference, "byteOffset", 0),
                                step, count, element_bytes);
    if (!elements) {
        reference.fail(
            fmt::format("asks for {} elements of {} bytes, which do not lie inside {} of {} bytes",
                        count, element_bytes, view.pointer(), view_length));
    }
    return *elements;
}

void check_type(const Json& accessor, std::string_view type, std::string_view purpose) {
    const Json found = accessor.require("type");
    if (found.text() != type) {
        found.fail(fmt::format("is {}; {} are {}", found.text(), purpose, type));
    }
}

std::uint64_t read_count(const Json& accessor) {
    const std::uint64_t count = accessor.require("count").whole(kMost);
    if (!accessor.find("bufferView") && count > kMaxVirtualElements) {
        accessor.fail(fmt::format("has {} elements but no bufferView; at most {} are taken", count,
                                  kMaxVirtualElements));
    }
    return count;
}

struct SparsePositions {
    Slice slice;
    std::uint64_t bytes = 0;
};

SparsePositions sparse_positions(Document& document, const Json& sparse, std::uint64_t count) {
    const Json indices = sparse.require("indices");
    const Json type = indices.require("componentType");
    const std::uint64_t bytes = index_bytes(type.whole(kMost));
    if (bytes == 0) type.fail("is no type of indices (5121, 5123 or 5125)");
    return {slice_of(document, indices, count, bytes), bytes};
}

}  // namespace

std::optional<Slice> slice(std::string_view bytes, std::uint64_t offset, std::uint64_t stride,
                           std::uint64_t count, std::uint64_t element_bytes) {
    if (offset > bytes.size()) return std::nullopt;
    const std::uint64_t room = bytes.size() - offset;
    if (count > 0) {
        std::uint64_t last = 0, end = 0;
        if (__builtin_mul_overflow(stride, count - 1, &last) ||
            __builtin_add_overflow(last, element_bytes, &end) || end > room) {
            return std::nullopt;
        }
    }
    return Slice{bytes.data() + offset, stride, count};
}

Vec3Accessor::Vec3Accessor(Document& document, const Json& index) {
    constexpr std::uint64_t kBytes = 12;
    const Json accessor = document.item("accessors", index);
    check_type(accessor, "VEC3", "positions and normals");
    const Json component = accessor.require("componentType");
    if (component.whole(kMost) != kFloat) {
        component.fail("is not 5126 (float): quantised meshes (KHR_mesh_quantization) are not read",
                       "export the file without compression of meshes");
    }
    count_ = read_count(accessor);
    if (accessor.find("bufferView")) dense_ = slice_of(document, accessor, count_, kBytes);
    const auto sparse = accessor.find("sparse");
    if (!sparse) return;
    const std::uint64_t changes = sparse->require("count").whole(count_);
    const SparsePositions positions = sparse_positions(document, *sparse, changes);
    const Slice values = slice_of(document, sparse->require("values"), changes, kBytes);
    for (std::uint64_t i = 0; i < changes; ++i) {
        sparse_[index_at(positions.slice, i, positions.bytes)] = vec3_at(values, i);
    }
}

Vec3 Vec3Accessor::operator[](std::uint64_t i) const {
    if (!sparse_.empty()) {
        const auto found = sparse_.find(i);
        if (found != sparse_.end()) return found->second;
    }
    return dense_ ? vec3_at(*dense_, i) : Vec3{};
}

std::vector<std::uint32_t> read_indices(Document& document, const Json& index) {
    const Json accessor = document.item("accessors", index);
    check_type(accessor, "SCALAR", "indices");
    const Json component = accessor.require("componentType");
    const std::uint64_t bytes = index_bytes(component.whole(kMost));
    if (bytes == 0) component.fail("is no type of indices (5121, 5123 or 5125)");
    const std::uint64_t count = read_count(accessor);
    std::vector<std::uint32_t> indices;
    if (accessor.find("bufferView")) {
        const Slice elements = slice_of(document, accessor, count, bytes);
        indices.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i) indices.push_back(index_at(elements, i, bytes));
    } else {
        indices.resize(count, 0);
    }
    const auto sparse = accessor.find("sparse");
    if (!sparse) return indices;
    const std::uint64_t changes = sparse->require("count").whole(count);
    const SparsePositions positions = sparse_positions(document, *sparse, changes);
    const Slice values = slice_of(document, sparse->require("values"), changes, bytes);
    for (std::uint64_t i = 0; i < changes; ++i) {
        const std::uint32_t where = index_at(positions.slice, i, positions.bytes);
        if (where >= count) sparse->fail(fmt::format("changes element {} of {}", where, count));
        indices[where] = index_at(values, i, bytes);
    }
    return indices;
}

}  // namespace dewbow::gltf
