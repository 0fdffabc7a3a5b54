// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers in buffers. Every byte that is read from a buffer goes through slice(): nothing else
// forms a position in one.

#include <unordered_map>

#include "dewbow/import/gltf/document.h"
#include "dewbow/math/vector.h"

namespace dewbow::gltf {

/// `count` elements of `element_bytes` each, `stride` apart. Positions are known to lie inside.
struct Slice {
    const char* first = nullptr;
    std::uint64_t stride = 0, count = 0;
};

/// The elements that begin at `offset` of `bytes`, or nothing if they do not all lie inside,
/// whatever the numbers.
std::optional<Slice> slice(std::string_view bytes, std::uint64_t offset, std::uint64_t stride,
                           std::uint64_t count, std::uint64_t element_bytes);

/// Most elements of an accessor that no bytes stand behind.
inline constexpr std::uint64_t kMaxVirtualElements = std::uint64_t{1} << 22;

/// An accessor of type VEC3, float.
class Vec3Accessor {
public:
    /// @param index  the reference to it, for instance of "POSITION". Throws InputError.
    Vec3Accessor(Document& document, const Json& index);

    std::uint64_t count() const { return count_; }
    /// `i` < count().
    Vec3 operator[](std::uint64_t i) const;

private:
    std::uint64_t count_ = 0;
    std::optional<Slice> dense_;  ///< none: zeros
    std::unordered_map<std::uint64_t, Vec3> sparse_;
};

/// An accessor of type SCALAR, unsigned byte, short or int. Throws InputError.
std::vector<std::uint32_t> read_indices(Document& document, const Json& index);

}  // namespace dewbow::gltf
