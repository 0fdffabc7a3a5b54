// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whether there is memory enough, asked before any is taken.

#include <cstdint>

#include "dewbow/render/film.h"

namespace dewbow {

/// Bytes that this process can still have, as far as the system tells: free and reclaimable memory,
/// and the limit on its address space.
std::uint64_t available_memory();

/// Bytes that the film of `crop` and the pictures made of it take at most.
/// @param light_paths  whether there are any: they may bring light to every pixel
std::uint64_t picture_memory(const PixelRect& crop, int spectral_bins, bool light_paths);

/// Throws InputError if `crop` does not fit into available_memory().
void check_memory(const PixelRect& crop, int spectral_bins, bool light_paths);

}  // namespace dewbow
