// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "dewbow/base/random.h"

namespace dewbow {

/// A hash of text, for names. It is no checksum: who wants to can find two texts of one hash.
constexpr std::uint64_t hash_of_text(std::string_view text) {
    std::uint64_t hash = text.size();
    for (const char c : text) hash = hash_combine(hash, static_cast<unsigned char>(c));
    return hash;
}

}  // namespace dewbow
