// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every byte that is read from a buffer goes through slice(): nothing else forms a position in one.

#include <cstdint>
#include <optional>
#include <string_view>

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

}  // namespace dewbow::gltf
