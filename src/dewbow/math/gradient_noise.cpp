// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/gradient_noise.h"

#include <array>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

/// The gradient at a lattice point of that number, times `offset` from there.
double ramp(std::uint64_t number, Vec3 offset) {
    static constexpr std::array<Vec3, 12> kGradients{{{1, 1, 0},
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
    const std::uint64_t hash = mix_bits(number) >> 32;
    return dot(kGradients[std::size_t(hash * kGradients.size() >> 32)], offset);
}

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
double mixed(double a, double b, double t) { return a + t * (b - a); }

/// std::floor is a call on plain x86-64.
std::int64_t floor_of(double x) {
    const auto whole = std::int64_t(x);
    return whole - (double(whole) > x);
}

}  // namespace

double gradient_noise(Vec3 p, std::uint64_t seed) {
    constexpr std::uint64_t kX = 0x9e3779b97f4a7c15ULL, kY = 0xc2b2ae3d27d4eb4fULL,
                            kZ = 0x165667b19e3779f9ULL;  // odd, and without a pattern
    const std::int64_t i = floor_of(p.x), j = floor_of(p.y), k = floor_of(p.z);
    const Vec3 f = p - Vec3{double(i), double(j), double(k)};
    const std::uint64_t corner =
        mix_bits(seed) + std::uint64_t(i) * kX + std::uint64_t(j) * kY + std::uint64_t(k) * kZ;
    const double u = fade(f.x), v = fade(f.y), w = fade(f.z);
    const auto row = [&](std::uint64_t at, double y, double z) {
        return mixed(ramp(at, {f.x, y, z}), ramp(at + kX, {f.x - 1.0, y, z}), u);
    };
    const auto plane = [&](std::uint64_t at, double z) {
        return mixed(row(at, f.y, z), row(at + kY, f.y - 1.0, z), v);
    };
    return mixed(plane(corner, f.z), plane(corner + kZ, f.z - 1.0), w);
}

}  // namespace dewbow
