// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace dewbow::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

constexpr std::uint64_t kMost = std::uint64_t{1} << 53;
constexpr std::uint64_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                        kUnsignedInt = 5125, kFloat = 5126;

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

template <class T>
double value_at(const char* where) {
    T value;
    std::memcpy(&value, where, sizeof value);
    return double(value);
}

/// The elements that `reference` (an accessor, or a part of its `sparse`) finds in its buffer view.
Slice slice_of(Document& document, const Json& reference, std::uint64_t count,
               std::uint64_t element_bytes) {
    const Document::View view = document.view(reference.require("bufferView"));
    // Old writers say 0 where elements follow each other.
    const std::uint64_t step = view.stride > 0 ? view.stride : element_bytes;
    if (step < element_bytes) {
        reference.fail(fmt::format("{}/byteStride is {}, less than the {} bytes of an element",
                                   view.pointer, step, element_bytes));
    }
    const auto elements =
        slice(view.bytes, whole(reference, "byteOffset", 0), step, count, element_bytes);
    if (!elements) {
        reference.fail(
            fmt::format("asks for {} elements of {} bytes, which do not lie inside {} of {} bytes",
                        count, element_bytes, view.pointer, view.bytes.size()));
    }
    return *elements;
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

/// Where element `i` of the sparse part goes.
std::uint32_t sparse_position(const Json& sparse, const SparsePositions& positions, std::uint64_t i,
                              std::uint64_t count) {
    const std::uint32_t where = index_at(positions.slice, i, positions.bytes);
    if (where >= count) sparse.fail(fmt::format("changes element {} of {}", where, count));
    return where;
}

/// "VEC3", or "VEC3 or VEC4".
std::string types_text(const AccessorUse& use) {
    constexpr std::string_view kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    std::string text{kTypes[use.least_components - 1]};
    for (int n = use.least_components + 1; n <= use.most_components; ++n)
        text.append(" or ").append(kTypes[n - 1]);
    return text;
}

int components_of(const std::string& type) {
    if (type == "SCALAR") return 1;
    return type.size() == 4 && type.starts_with("VEC") ? type[3] - '0' : 0;
}

}  // namespace

Accessor::Accessor(Document& document, const Json& index, const AccessorUse& use) {
    const Json accessor = document.item("accessors", index);
    read_type(accessor, use);
    read_component(accessor, use);
    count_ = read_count(accessor);
    const std::uint64_t bytes = component_bytes() * std::uint64_t(components_);
    if (accessor.find("bufferView")) dense_ = slice_of(document, accessor, count_, bytes);
    if (const auto sparse = accessor.find("sparse")) read_sparse(document, *sparse);
}

Accessor::Accessor(std::shared_ptr<const std::vector<float>> values, int components)
    : count_(values->size() / std::uint64_t(components)),
      components_(components),
      dense_(Slice{reinterpret_cast<const char*>(values->data()),
                   sizeof(float) * std::uint64_t(components), count_}),
      owned_(std::move(values)) {}

void Accessor::read_type(const Json& accessor, const AccessorUse& use) {
    const Json type = accessor.require("type");
    components_ = components_of(type.text());
    if (components_ < use.least_components || components_ > use.most_components)
        type.fail(fmt::format("is {}; {} are {}", type.text(), use.what, types_text(use)));
}

void Accessor::read_component(const Json& accessor, const AccessorUse& use) {
    const Json component = accessor.require("componentType");
    switch (component.whole(kMost)) {
        case kByte:
            component_ = Component::byte;
            break;
        case kUnsignedByte:
            component_ = Component::unsigned_byte;
            break;
        case kShort:
            component_ = Component::short_;
            break;
        case kUnsignedShort:
            component_ = Component::unsigned_short;
            break;
        case kFloat:
            component_ = Component::float_;
            break;
        default:
            component.fail(fmt::format(
                "is no type of {} (5126 float, 5120 to 5123 whole numbers of 8 or 16 bits)",
                use.what));
    }
    const auto normalised = accessor.find("normalized");
    normalised_ = component_ != Component::float_ &&
                  (use.always_normalised || (normalised && normalised->boolean()));
}

void Accessor::read_sparse(Document& document, const Json& sparse) {
    const std::uint64_t changes = sparse.require("count").whole(count_);
    const SparsePositions positions = sparse_positions(document, sparse, changes);
    const Slice values = slice_of(document, sparse.require("values"), changes,
                                  component_bytes() * std::uint64_t(components_));
    for (std::uint64_t i = 0; i < changes; ++i)
        sparse_[sparse_position(sparse, positions, i, count_)] = element_at(values, i);
}

std::uint64_t Accessor::component_bytes() const {
    switch (component_) {
        case Component::byte:
        case Component::unsigned_byte:
            return 1;
        case Component::short_:
        case Component::unsigned_short:
            return 2;
        case Component::float_:
            break;
    }
    return 4;
}

double Accessor::component_at(const char* where) const {
    const auto scaled = [&](double value, double most) {
        return normalised_ ? std::max(value / most, -1.0) : value;
    };
    switch (component_) {
        case Component::byte:
            return scaled(value_at<std::int8_t>(where), 127.0);
        case Component::unsigned_byte:
            return scaled(value_at<std::uint8_t>(where), 255.0);
        case Component::short_:
            return scaled(value_at<std::int16_t>(where), 32767.0);
        case Component::unsigned_short:
            return scaled(value_at<std::uint16_t>(where), 65535.0);
        case Component::float_:
            break;
    }
    return value_at<float>(where);
}

Accessor::Element Accessor::element_at(const Slice& slice, std::uint64_t i) const {
    Element element{};
    const char* const first = slice.first + i * slice.stride;
    const std::uint64_t step = component_bytes();
    for (std::size_t c = 0; c < std::size_t(components_); ++c)
        element[c] = component_at(first + c * step);
    return element;
}

Accessor::Element Accessor::operator[](std::uint64_t i) const {
    if (!sparse_.empty()) {
        const auto found = sparse_.find(i);
        if (found != sparse_.end()) return found->second;
    }
    return dense_ ? element_at(*dense_, i) : Element{};
}

std::vector<std::uint32_t> read_indices(Document& document, const Json& index) {
    const Json accessor = document.item("accessors", index);
    const Json type = accessor.require("type");
    if (type.text() != "SCALAR") type.fail(fmt::format("is {}; indices are SCALAR", type.text()));
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
    for (std::uint64_t i = 0; i < changes; ++i)
        indices[sparse_position(*sparse, positions, i, count)] = index_at(values, i, bytes);
    return indices;
}

}  // namespace dewbow::gltf
