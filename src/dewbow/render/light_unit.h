// SPDX-License-Identifier: Apache-2.0
#pragma once

// A piece of work for light paths: done whole or not at all, as tiles are.

#include <cstdint>

#include "dewbow/base/random.h"

namespace dewbow {

/// Light paths [first_path, end_path) of one pass. They belong to the whole picture, whatever crop
/// of it is rendered.
struct LightUnit {
    std::uint64_t pass = 0;
    std::uint64_t first_path = 0, end_path = 0;

    std::uint64_t paths() const { return end_path - first_path; }
    bool operator==(const LightUnit&) const = default;
};

/// All random numbers of light path `path` of `pass`. The paths of a pass are stratified together,
/// 2³² at a time.
constexpr SampleKey light_path_key(std::uint64_t seed, std::uint64_t pass, std::uint64_t path) {
    return {hash_combine(light_stream_key(seed, pass), path >> 32),
            static_cast<std::uint32_t>(path)};
}

}  // namespace dewbow
