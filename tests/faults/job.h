// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render that lasts long enough to be disturbed, and keeps its state on the way.

#include <chrono>
#include <cstddef>

#include "tiny_render.h"

namespace dewbow::faults {

using Seconds = std::chrono::duration<double>;

inline constexpr const char* kOutput = "ring.exr";
/// Where its state is kept.
inline constexpr const char* kState = "ring.exr.dewbow";

/// 48x48 pixels of kTinyScene; half a second of one processor for 100 samples a pixel.
struct Job {
    int samples_per_pixel = 120;
    Seconds checkpoint_every{0.05};

    Words words(int threads, const Words& more = {}) const;
};

/// Of the state that is kept in the folder; 0 if none is.
std::size_t finished_units(const Folder& folder);

/// --resume, if a state is kept: the first one may have been too far away.
Words resume(const Folder& folder);

/// Renders until a state was kept, and then sends the signal.
Outcome interrupt(const Job& job, const Folder& folder, int signal);

}  // namespace dewbow::faults
