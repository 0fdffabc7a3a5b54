// SPDX-License-Identifier: Apache-2.0
#include "micro/fma_peak.h"

#include "micro/cpu_time.h"

namespace dewbow::bench {
namespace {

constexpr int kChains = 16, kRounds = 1000000;

template <int kLanes>
struct Lanes {
    typedef double Vector __attribute__((vector_size(8 * kLanes)));
};

template <int kLanes>
[[gnu::always_inline]] inline double chains(double factor, double addend) {
    using Vector = typename Lanes<kLanes>::Vector;
    Vector sums[kChains], factors, addends;
    for (int lane = 0; lane < kLanes; ++lane) {
        factors[lane] = factor;
        addends[lane] = addend;
    }
    for (Vector& sum : sums) sum = addends;
    for (int round = 0; round < kRounds; ++round)
        for (int i = 0; i < kChains; ++i) sums[i] = sums[i] * factors + addends;
    double total = 0.0;
    for (const Vector& sum : sums) total += sum[0];
    return total;
}

double plain(double factor, double addend) { return chains<2>(factor, addend); }
#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma")]] double avx2(double factor, double addend) {
    return chains<4>(factor, addend);
}
[[gnu::target("avx2,fma,avx512f")]] double avx512(double factor, double addend) {
    return chains<8>(factor, addend);
}
#endif

}  // namespace

double multiply_adds_per_second(std::string_view variant) {
    double (*loop)(double, double) = plain;
    int lanes = 2;
#if defined(__x86_64__) && defined(__GNUC__)
    if (variant == "AVX2 and FMA") loop = avx2, lanes = 4;
    if (variant == "AVX-512") loop = avx512, lanes = 8;
#endif
    volatile double result = 0.0, factor = 0.999999, addend = 1e-6;
    const double seconds = least_cpu_seconds(20, [&] { result = loop(factor, addend); });
    return double(kChains) * kRounds * lanes / seconds;
}

}  // namespace dewbow::bench
