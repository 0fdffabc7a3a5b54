// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_kernel.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#define DEWBOW_INLINE [[gnu::always_inline]] inline
// g++ would load a vector anew for each of its uses, and loads are what is short then.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DEWBOW_IN_REGISTER(vector) asm("" : "+v"(vector))
#else
#define DEWBOW_IN_REGISTER(vector)
#endif

namespace dewbow {
namespace {

/// Orders between which the sums of one sphere rest in registers: π_n ± τ_n of that many orders and
/// of a block's angles stay in a first-level cache of 32 KiB.
constexpr int kBlockOrders = 40;
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

/// Vectors of an instruction set.
template <int lanes, int registers>
struct Lanes {
    static constexpr int kLanes = lanes, kRegisters = registers;
    typedef double Vector __attribute__((vector_size(8 * lanes)));
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
///                                                    [after Wiscombe 1980, Appl. Opt. 19, 1505]
template <class L>
DEWBOW_INLINE void continue_table(int n, int count, Recurrence& at, Table& plus, Table& minus) {
    using Vector = typename L::Vector;
    constexpr int kLanes = L::kLanes, kVectors = L::kRegisters == 32 ? 6 : 3;
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

/// Real and imaginary part of one sum, by angle.
using Sum = double[2][kBlockAngles];

/// What a table is multiplied with, from its first order on, and the sum that this belongs to;
/// nothing to do if that is nullptr.
struct Addend {
    const double* factors;
    Sum* sum;
};

/// A tile of one sum in registers: Σ_n factor × value, or the alternating one that is taken from
/// the next product each time, Σ_n (−1)^{last − n} factor × value.
template <class L, bool kAlternating>
class SumTile {
public:
    DEWBOW_INLINE SumTile(const Addend& addend, int first)
        : factors_(addend.factors),
          re_to_((*addend.sum)[0] + first),
          im_to_((*addend.sum)[1] + first) {
        for (int v = 0; v < kTile; ++v) {
            re_[v] = L::load(re_to_ + v * L::kLanes);
            im_[v] = L::load(im_to_ + v * L::kLanes);
        }
    }
    DEWBOW_INLINE void add(int i, int v, typename L::Vector value) {
        if constexpr (kAlternating) {
            re_[v] = factors_[2 * i] * value - re_[v];
            im_[v] = factors_[2 * i + 1] * value - im_[v];
        } else {
            re_[v] += factors_[2 * i] * value;
            im_[v] += factors_[2 * i + 1] * value;
        }
    }
    DEWBOW_INLINE void store() const {
        for (int v = 0; v < kTile; ++v) {
            L::store(re_to_ + v * L::kLanes, re_[v]);
            L::store(im_to_ + v * L::kLanes, im_[v]);
        }
    }

private:
    const double* factors_;
    double *re_to_, *im_to_;
    typename L::Vector re_[kTile], im_[kTile];
};

/// Adds `count` orders to tiles that begin at angle `first`.
template <class L, class... Tiles>
DEWBOW_INLINE void add_to_tiles(int count, const Table& table, int first, Tiles... tiles) {
    for (int i = 0; i < count; ++i)
        for (int v = 0; v < kTile; ++v) {
            typename L::Vector value = L::load(table.values[i] + first + v * L::kLanes);
            DEWBOW_IN_REGISTER(value);
            (tiles.add(i, v, value), ...);
        }
    (tiles.store(), ...);
}

/// Both sums at once share the loads of the table, where there are registers for both, the four
/// factors and a value.
template <class L>
DEWBOW_INLINE void add_table(int count, const Table& table, Addend straight, Addend alternating) {
    constexpr bool kTogether = L::kRegisters >= 4 * kTile + 5;
    for (int first = 0; first < kBlockAngles; first += kTile * L::kLanes)
        if (kTogether && straight.sum && alternating.sum) {
            add_to_tiles<L>(count, table, first, SumTile<L, false>(straight, first),
                            SumTile<L, true>(alternating, first));
        } else {
            if (straight.sum)
                add_to_tiles<L>(count, table, first, SumTile<L, false>(straight, first));
            if (alternating.sum)
                add_to_tiles<L>(count, table, first, SumTile<L, true>(alternating, first));
        }
}

/// Gives alternating sums of an even number of orders the sign (−1)^{n+1}.
void negate(BlockSums& sums) {
    for (Sum* sum : {&sums.plus, &sums.minus})
        for (int part = 0; part < 2; ++part)
            for (int i = 0; i < kBlockAngles; ++i) (*sum)[part][i] = -(*sum)[part][i];
}

template <class L>
DEWBOW_INLINE void sum_block_with(std::span<const WaveFactors> spheres,
                                  std::span<const double> epsilon, std::span<BlockSums> forward,
                                  std::span<BlockSums> backward) {
    std::fill(forward.begin(), forward.end(), BlockSums{});
    std::fill(backward.begin(), backward.end(), BlockSums{});
    int orders = 0;
    for (const WaveFactors& sphere : spheres)
        orders = std::max(orders, int(sphere.plus.size() / 2));
    Recurrence angles(epsilon);
    Table plus, minus;
    for (int done = 0; done < orders; done += kBlockOrders) {
        continue_table<L>(done + 1, std::min(kBlockOrders, orders - done), angles, plus, minus);
        for (std::size_t s = 0; s < spheres.size(); ++s) {
            const int count = std::min(kBlockOrders, int(spheres[s].plus.size() / 2) - done);
            if (count <= 0) continue;
            BlockSums* f = forward.empty() ? nullptr : &forward[s];
            BlockSums* b = backward.empty() ? nullptr : &backward[s];
            const double* p = spheres[s].plus.data() + 2 * done;
            const double* m = spheres[s].minus.data() + 2 * done;
            add_table<L>(count, plus, {p, f ? &f->plus : nullptr}, {m, b ? &b->minus : nullptr});
            add_table<L>(count, minus, {m, f ? &f->minus : nullptr}, {p, b ? &b->plus : nullptr});
        }
    }
    for (std::size_t s = 0; s < backward.size(); ++s)
        if (spheres[s].plus.size() / 2 % 2 == 0) negate(backward[s]);
}

void sum_block_plain(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
                     std::span<BlockSums> forward, std::span<BlockSums> backward) {
    sum_block_with<Lanes<2, 16>>(spheres, epsilon, forward, backward);
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma")]] void sum_block_avx2(std::span<const WaveFactors> spheres,
                                                std::span<const double> epsilon,
                                                std::span<BlockSums> forward,
                                                std::span<BlockSums> backward) {
    sum_block_with<Lanes<4, 16>>(spheres, epsilon, forward, backward);
}
[[gnu::target("avx2,fma,avx512f")]] void sum_block_avx512(std::span<const WaveFactors> spheres,
                                                          std::span<const double> epsilon,
                                                          std::span<BlockSums> forward,
                                                          std::span<BlockSums> backward) {
    sum_block_with<Lanes<8, 32>>(spheres, epsilon, forward, backward);
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
               std::span<BlockSums> forward, std::span<BlockSums> backward) {
    static const SumBlockVariant& best = *std::find_if(std::begin(kVariants), std::end(kVariants),
                                                       [](auto& v) { return v.is_supported(); });
    best.sum_block(spheres, epsilon, forward, backward);
}

}  // namespace dewbow
