// SPDX-License-Identifier: Apache-2.0
#pragma once

// The true picture of a scene of caustics, by a way that no contestant goes. Light whose first
// meeting is a body walks from the lamps, one wavelength at a time, along even points over lamp,
// gate and spectrum, and is counted in the pixel that sees where it lands. Light whose first
// meeting is a receiver is summed from the eye: each walk takes direct light at every receiver that
// it comes to. Every path is of one kind alone. What stands behind glass is not looked at: those
// pixels are no part of any mask.

#include "picture.h"
#include "plain_scene.h"

namespace dewbow::bench {

/// What the camera sees straight.
struct SeenPicture {
    Picture picture;
    /// Pixels that show receivers alone: no body, no lamp, no void.
    std::vector<bool> receivers;
};
/// Light straight from the lamps on what is seen.
/// @param samples  points over pixel and lamp for each pixel, at least 1.
SeenPicture direct_picture(const PlainScene& scene, int samples, std::uint64_t seed);
/// And what comes to there from other receivers, past bodies or through them.
SeenPicture camera_picture(const PlainScene& scene, int samples, std::uint64_t seed);

/// Light whose first meeting is a body.
/// @param paths  in all; each one is seen in the picture wherever it meets a receiver.
Picture forward_picture(const PlainScene& scene, std::uint64_t paths, std::uint64_t seed);

/// All light.
/// @param samples  paths for each pixel of the picture; from the eye a fourth as many.
Picture lit_picture(const PlainScene& scene, int samples, std::uint64_t seed);

}  // namespace dewbow::bench
