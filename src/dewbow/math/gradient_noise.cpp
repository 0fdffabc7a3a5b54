// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/gradient_noise.h"

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

/// The gradient at a lattice point, times `offset` from there.
double ramp(std::uint64_t hash, Vec3 offset) {
    // Middles of the twelve edges of a cube; four of them twice, as in the source.
    static constexpr signed char kGradients[16][3] = {
        {1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
        {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
        {1, 1, 0},  {-1, 1, 0},  {0, -1, 1}, {0, -1, -1}};
    const auto& g = kGradients[hash & 15];
    return g[0] * offset.x + g[1] * offset.y + g[2] * offset.z;
}

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
double mixed(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

double gradient_noise(Vec3 p, std::uint64_t seed) {
    const Vec3 corner{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const Vec3 f = p - corner;
    const auto ix = std::int64_t(corner.x), iy = std::int64_t(corner.y),
               iz = std::int64_t(corner.z);
    const auto at = [&](int dx, int dy, int dz) {
        std::uint64_t hash = hash_combine(seed, std::uint64_t(ix + dx));
        hash = hash_combine(hash, std::uint64_t(iy + dy));
        hash = hash_combine(hash, std::uint64_t(iz + dz));
        return ramp(hash, f - Vec3{double(dx), double(dy), double(dz)});
    };
    const double u = fade(f.x), v = fade(f.y), w = fade(f.z);
    const auto row = [&](int dy, int dz) { return mixed(at(0, dy, dz), at(1, dy, dz), u); };
    const auto plane = [&](int dz) { return mixed(row(0, dz), row(1, dz), v); };
    return mixed(plane(0), plane(1), w);
}

}  // namespace dewbow
