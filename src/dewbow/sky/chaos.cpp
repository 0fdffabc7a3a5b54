// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/chaos.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

/// Of gradient_noise: 16 · (181/462)² · 535/18018, the mean over a cell of Σ w² (g·d)² over its
/// corners, with weights w, offsets d and gradients g that are independent and of length √2.
constexpr double kNoiseVariance = 35054270.0 / 480729249.0;
/// Beyond it a double no longer tells a point from its neighbours in the cell.
constexpr double kFarAway = 4503599627370496.0;  // 2⁵²
constexpr double kDeviations = 3.0;              ///< that have room between 1/2 and the ends

/// From the middle of a cube to the middles of its edges: no direction is favoured, and a product
/// with one is a sum.                                [Perlin, "Improving Noise", SIGGRAPH 2002]
constexpr std::array<Vec3, 12> kGradients{{{1, 1, 0},
                                           {-1, 1, 0},
                                           {1, -1, 0},
                                           {-1, -1, 0},
                                           {1, 0, 1},
                                           {-1, 0, 1},
                                           {1, 0, -1},
                                           {-1, 0, -1},
                                           {0, 1, 1},
                                           {0, -1, 1},
                                           {0, 1, -1},
                                           {0, -1, -1}}};

/// 6x⁵ − 15x⁴ + 10x³: the first two derivatives vanish at 0 and 1.
double fade(double x) { return x * x * x * (x * (x * 6.0 - 15.0) + 10.0); }

double mixed(double a, double b, double share) { return a + (b - a) * share; }

/// (g·d) at a corner of a cell.
/// @param place  the corner's own number.   @param d  from the corner.
double corner(std::uint64_t place, Vec3 d) {
    const std::uint64_t hash = mix_bits(place) >> 32;
    return dot(kGradients[std::size_t(hash * kGradients.size() >> 32)], d);
}

/// Not std::floor, which is a call on plain x86-64.
std::int64_t floor_of(double x) {
    const auto whole = std::int64_t(x);
    return whole - (double(whole) > x);
}

/// About −1 to 1, 0 at the lattice's points, and of mean 0.
double gradient_noise(Vec3 p, std::uint64_t key) {
    constexpr std::uint64_t kX = 0x9e3779b97f4a7c15ULL, kY = 0xc2b2ae3d27d4eb4fULL,
                            kZ = 0x165667b19e3779f9ULL;  // odd and without pattern
    const std::int64_t i = floor_of(p.x), j = floor_of(p.y), k = floor_of(p.z);
    const Vec3 d = p - Vec3{double(i), double(j), double(k)};
    const std::uint64_t place =
        key + std::uint64_t(i) * kX + std::uint64_t(j) * kY + std::uint64_t(k) * kZ;
    const double u = fade(d.x), v = fade(d.y), w = fade(d.z);
    const auto edge = [&](std::uint64_t at, double y, double z) {
        return mixed(corner(at, {d.x, y, z}), corner(at + kX, {d.x - 1.0, y, z}), u);
    };
    const auto face = [&](std::uint64_t at, double z) {
        return mixed(edge(at, d.y, z), edge(at + kY, d.y - 1.0, z), v);
    };
    return mixed(face(place, d.z), face(place + kZ, d.z - 1.0), w);
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
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kFarAway)) break;
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
