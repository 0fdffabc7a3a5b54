// SPDX-License-Identifier: Apache-2.0
#pragma once

// What pictures are compared with, kept in a folder from one run of the benchmark to the next.

#include <filesystem>

#include "contestant.h"
#include "picture_errors.h"

namespace dewbow::bench {

/// Where references lie, and how good they are to be.
struct ReferenceSettings {
    std::filesystem::path folder;
    int truth_samples = 2048;  ///< of each half of the true picture, per pixel
    int limit_spectral_samples = 400;
    /// Of each half of a contestant's own limit; more than in its runs, for regular grids would
    /// hide their own error.
    int limit_samples_per_pixel = 16;
};

/// The true picture (exact_picture), from the folder if it was made before. A change of the scene,
/// of the size or of the samples makes another file.
Reference true_picture(const BenchScene& scene, const ReferenceSettings& settings);

/// What `contestant` converges to; also keyed by what it is told and the bytes of its program.
/// Throws InputError if its program fails.
Reference own_limit(const BenchScene& scene, const Contestant& contestant,
                    const ReferenceSettings& settings);

}  // namespace dewbow::bench
