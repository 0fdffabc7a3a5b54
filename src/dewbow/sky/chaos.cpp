// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/chaos.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/random.h"
#include "dewbow/math/gradient_noise.h"

namespace dewbow {
namespace {

/// Of gradient_noise: 16 · (181/462)² · 535/18018, the mean over a cell of Σ w² (g·d)² over its
/// corners, with weights w, offsets d and gradients g that are independent and of length √2.
constexpr double kNoiseVariance = 35054270.0 / 480729249.0;
/// Beyond it a double no longer tells a point from its neighbours in the cell.
constexpr double kFarAway = 4503599627370496.0;  // 2⁵²
constexpr double kDeviations = 3.0;              ///< that have room between 1/2 and the ends

bool has_place(Vec3 p) {
    return std::abs(p.x) < kFarAway && std::abs(p.y) < kFarAway && std::abs(p.z) < kFarAway;
}

/// Where in a cell an octave begins: else all of them would be 0 at the points of the first.
Vec3 offset(std::uint64_t key) {
    const auto part = [&](std::uint64_t axis) {
        return double(hash_combine(key, axis) >> 11) * 0x1p-53;
    };
    return {part(0), part(1), part(2)};
}

}  // namespace

double chaos(Vec3 p, const Chaos& texture) {
    p = p + texture.axis * (dot(texture.axis, p) * (1.0 / texture.stretch - 1.0));
    p = p * texture.base_frequency;
    const double decay = std::pow(texture.lacunarity, -0.5 * (texture.exponent - 1.0));
    double sum = 0.0, variance = 0.0, amplitude = 1.0;
    for (int octave = 0; octave < texture.octaves; ++octave) {
        if (!has_place(p)) break;
        const std::uint64_t key = hash_combine(texture.seed, std::uint64_t(octave));
        sum += amplitude * gradient_noise(p + offset(key), key);
        variance += amplitude * amplitude * kNoiseVariance;
        p = p * texture.lacunarity;
        amplitude *= decay;
    }
    if (variance == 0.0) return 0.5;
    return std::clamp(0.5 + 0.5 / kDeviations * sum / std::sqrt(variance), 0.0, 1.0);
}

double chaos_density(Vec3 p, const Chaos& texture) {
    return std::clamp(texture.bias + texture.gain * chaos(p, texture), 0.0, 1.0);
}

}  // namespace dewbow
