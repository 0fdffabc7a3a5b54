// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_kernel.h"

#include <algorithm>
#include <cstddef>

#define DEWBOW_INLINE [[gnu::always_inline]] inline
// g++ would load a vector anew for each of its uses, and loads are what is short then.
#if defined(__x86_64__) && defined(__GNUC__)
#define DEWBOW_IN_REGISTER(vector) asm("" : "+v"(vector))
#else
#define DEWBOW_IN_REGISTER(vector)
#endif

namespace dewbow {
namespace {

/// Orders between which the sums of one sphere rest in registers: π_n ± τ_n of that many orders and
/// of a block's angles stay in a first-level cache of 32 KiB.
constexpr int kBlockOrders = 32;
/// Vectors of a sum's real and imaginary part in registers: 12 chains hide the latency of an FMA.
constexpr int kTile = 6;

/// [order][angle]
struct Table {
    alignas(64) double values[kBlockOrders][kBlockAngles];
};
/// How far the recurrence has come, by angle.
struct Recurrence {
    alignas(64) double epsilon[kBlockAngles];     ///< 1 − cos θ
    alignas(64) double pi[kBlockAngles];          ///< π_n
    alignas(64) double before[kBlockAngles];      ///< π_{n−1}
    alignas(64) double difference[kBlockAngles];  ///< π_n − π_{n−1}

    /// At n = 1. Angles that are not given are 90°.
    explicit Recurrence(std::span<const double> epsilons) {
        std::fill_n(epsilon, kBlockAngles, 1.0);
        std::copy(epsilons.begin(), epsilons.end(), epsilon);
        std::fill_n(pi, kBlockAngles, 1.0);
        std::fill_n(before, kBlockAngles, 0.0);
        std::fill_n(difference, kBlockAngles, 1.0);
    }
};

template <int kLanes>
struct Lanes {
    typedef double Vector __attribute__((vector_size(8 * kLanes)));
    DEWBOW_INLINE static Vector load(const double* from) {
        Vector v;
        __builtin_memcpy(&v, from, sizeof(v));
        return v;
    }
    DEWBOW_INLINE static void store(double* to, Vector v) { __builtin_memcpy(to, &v, sizeof(v)); }
};

/// `count` orders from `n` on of π + τ and π − τ. In differences d_n = π_n − π_{n−1}, with
/// t = d_n − ε π_n: τ_n = n t − π_{n−1} and d_{n+1} = t + t/n − ε π_n. Unlike the recurrence in μ
/// this loses nothing near the axis, where ε = 1 − μ is small.
///                                                    [after Wiscombe 1980, Appl. Opt. 19, 1505,
///                                                    eq. 18]
template <class L>
DEWBOW_INLINE void continue_table(int n, int count, Recurrence& at, Table& plus, Table& minus) {
    using Vector = typename L::Vector;
    constexpr int kLanes = sizeof(Vector) / sizeof(double), kVectors = kLanes == 8 ? 6 : 3;
    for (int first = 0; first < kBlockAngles; first += kVectors * kLanes) {
        Vector pi[kVectors], before[kVectors], difference[kVectors], e[kVectors];
        for (int v = 0; v < kVectors; ++v) {
            pi[v] = L::load(at.pi + first + v * kLanes);
            before[v] = L::load(at.before + first + v * kLanes);
            difference[v] = L::load(at.difference + first + v * kLanes);
            e[v] = L::load(at.epsilon + first + v * kLanes);
        }
        for (int i = 0; i < count; ++i) {
            const double order = n + i, step = 1.0 + 1.0 / order;
            for (int v = 0; v < kVectors; ++v) {
                const Vector ep = e[v] * pi[v], t = difference[v] - ep, tau = order * t - before[v];
                L::store(plus.values[i] + first + v * kLanes, pi[v] + tau);
                L::store(minus.values[i] + first + v * kLanes, pi[v] - tau);
                difference[v] = step * t - ep;
                before[v] = pi[v];
                pi[v] += difference[v];
            }
        }
        for (int v = 0; v < kVectors; ++v) {
            L::store(at.pi + first + v * kLanes, pi[v]);
            L::store(at.before + first + v * kLanes, before[v]);
            L::store(at.difference + first + v * kLanes, difference[v]);
        }
    }
}

/// Adds the table's first `count` orders, times a sphere's factors of these.
template <class L>
DEWBOW_INLINE void add_table(int count, const Table& table, const double* factors,
                             double (&sums)[2][kBlockAngles]) {
    using Vector = typename L::Vector;
    constexpr int kLanes = sizeof(Vector) / sizeof(double);
    for (int first = 0; first < kBlockAngles; first += kTile * kLanes) {
        Vector re[kTile], im[kTile];
        for (int v = 0; v < kTile; ++v) {
            re[v] = L::load(sums[0] + first + v * kLanes);
            im[v] = L::load(sums[1] + first + v * kLanes);
        }
        for (int i = 0; i < count; ++i)
            for (int v = 0; v < kTile; ++v) {
                Vector angular = L::load(table.values[i] + first + v * kLanes);
                DEWBOW_IN_REGISTER(angular);
                re[v] += factors[2 * i] * angular;
                im[v] += factors[2 * i + 1] * angular;
            }
        for (int v = 0; v < kTile; ++v) {
            L::store(sums[0] + first + v * kLanes, re[v]);
            L::store(sums[1] + first + v * kLanes, im[v]);
        }
    }
}

template <class L>
DEWBOW_INLINE void sum_block_with(std::span<const WaveFactors> spheres,
                                  std::span<const double> epsilon, std::span<BlockSums> sums) {
    std::size_t size = 0;
    for (std::size_t s = 0; s < spheres.size(); ++s) {
        sums[s] = {};
        size = std::max(size, spheres[s].plus.size());
    }
    Recurrence angles(epsilon);
    Table plus, minus;
    const int orders = int(size / 2);
    for (int done = 0; done < orders; done += kBlockOrders) {
        continue_table<L>(done + 1, std::min(kBlockOrders, orders - done), angles, plus, minus);
        for (std::size_t s = 0; s < spheres.size(); ++s) {
            const int count = std::min(kBlockOrders, int(spheres[s].plus.size() / 2) - done);
            if (count <= 0) continue;
            add_table<L>(count, plus, spheres[s].plus.data() + 2 * done, sums[s].plus);
            add_table<L>(count, minus, spheres[s].minus.data() + 2 * done, sums[s].minus);
        }
    }
}

void sum_block_plain(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
                     std::span<BlockSums> sums) {
    sum_block_with<Lanes<2>>(spheres, epsilon, sums);
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma")]] void sum_block_avx2(std::span<const WaveFactors> spheres,
                                                std::span<const double> epsilon,
                                                std::span<BlockSums> sums) {
    sum_block_with<Lanes<4>>(spheres, epsilon, sums);
}
[[gnu::target("avx2,fma,avx512f,prefer-vector-width=512")]] void sum_block_avx512(
    std::span<const WaveFactors> spheres, std::span<const double> epsilon,
    std::span<BlockSums> sums) {
    sum_block_with<Lanes<8>>(spheres, epsilon, sums);
}
#endif

constexpr SumBlockVariant kVariants[] = {
#if defined(__x86_64__) && defined(__GNUC__)
    {"AVX-512", [] { return bool(__builtin_cpu_supports("avx512f")); }, sum_block_avx512},
    {"AVX2 and FMA", [] { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); },
     sum_block_avx2},
#endif
    {"plain", [] { return true; }, sum_block_plain},
};

}  // namespace

std::span<const SumBlockVariant> sum_block_variants() { return kVariants; }

void sum_block(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
               std::span<BlockSums> sums) {
    static const SumBlockVariant& best = *std::find_if(std::begin(kVariants), std::end(kVariants),
                                                       [](auto& v) { return v.is_supported(); });
    best.sum_block(spheres, epsilon, sums);
}

}  // namespace dewbow
