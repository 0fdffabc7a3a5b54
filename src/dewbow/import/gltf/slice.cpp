// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/slice.h"

namespace dewbow::gltf {

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

}  // namespace dewbow::gltf
