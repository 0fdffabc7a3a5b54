// SPDX-License-Identifier: Apache-2.0
#pragma once

// The true picture of a plain scene, by a way that no contestant goes: all that a camera ray
// becomes in a convex body is one chain (at each face a part leaves, the rest stays), which is
// summed and not sampled; what is left to integrate is the pixel's square and the wavelength.

#include "picture.h"
#include "plain_scene.h"

namespace dewbow::bench {

/// @param samples  points over pixel and wavelength, at least 1.
/// @param seed     of the points' shift, another one in each pixel.
Picture exact_picture(const PlainScene& scene, int samples, std::uint64_t seed);

/// What the chain of one ray brings home.
/// Spectral radiance at `lambda_nm`, W m⁻² sr⁻¹ nm⁻¹, through the film's point (x, y) in pixels.
double exact_radiance(const PlainScene& scene, double x, double y, double lambda_nm);

/// Pixels that show nothing but the lamp of that name, straight.
std::vector<bool> pixels_of_lamp(const PlainScene& scene, const std::string& name);

}  // namespace dewbow::bench
