// SPDX-License-Identifier: Apache-2.0
#pragma once

// Points that lie evenly in a cube: multiples of an irrational vector, shifted at random.

#include <array>
#include <cmath>
#include <cstdint>

#include "dewbow/base/random.h"

namespace dewbow::bench {

/// The steps are powers of 1/g, where g^(N+1) = g + 1. [Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences"]
template <std::size_t N>
class EvenPoints {
public:
    explicit EvenPoints(std::uint64_t seed) {
        constexpr int kIterations = 64;
        double g = 1.5;
        for (int i = 0; i < kIterations; ++i) g = std::pow(1.0 + g, 1.0 / double(N + 1));
        double step = 1.0;
        for (std::size_t k = 0; k < N; ++k) {
            step_[k] = step /= g;
            shift_[k] = double(hash_combine(seed, k) >> 11) * 0x1p-53;
        }
    }
    /// The point of that number.
    std::array<double, N> operator[](std::uint64_t i) const {
        std::array<double, N> point{};
        for (std::size_t k = 0; k < N; ++k) {
            const double x = shift_[k] + double(i) * step_[k];
            point[k] = x - std::floor(x);
        }
        return point;
    }

private:
    std::array<double, N> step_{}, shift_{};
};

}  // namespace dewbow::bench
