// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/random.h"

namespace dewbow {

namespace {

// A base-2 nested uniform (Owen) scramble flips each bit of x by a random function of the more
// significant bits. On the reversed number "more significant" becomes "lower", and the arithmetic
// of integers, whose carries run only upwards, is such a function. [Laine & Karras 2011, §3.1]

constexpr std::uint64_t kGolden =
    0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio, odd: a Weyl sequence

/// Reverses the bits of both 32-bit halves, each in itself.
constexpr std::uint64_t reverse_bits_of_halves(std::uint64_t v) {
    v = ((v >> 1) & 0x5555555555555555ULL) | ((v & 0x5555555555555555ULL) << 1);
    v = ((v >> 2) & 0x3333333333333333ULL) | ((v & 0x3333333333333333ULL) << 2);
    v = ((v >> 4) & 0x0f0f0f0f0f0f0f0fULL) | ((v & 0x0f0f0f0f0f0f0f0fULL) << 4);
    v = __builtin_bswap64(v);  // also exchanges the halves
    return (v >> 32) | (v << 32);
}
constexpr std::uint32_t reverse_bits(std::uint32_t v) {
    v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
    v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
    v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(v);
}

/// Owen scramble of a reversed number. Each step is a bijection in which bit k depends on bits 0 to
/// k only. Multipliers: found by Nathan Vegdahl's search for the least bias ("Building a Better LK
/// Hash", 2021).
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Second dimension of Sobol's sequence at the index with these bits, reversed. Its generator
/// matrix is Pascal's triangle mod 2: the index as a polynomial over GF(2), with t replaced by 1 +
/// t; and since (1 + t)^(2^k) = 1 + t^(2^k), each halving of the polynomial is one exclusive or.
constexpr std::uint32_t sobol_1_reversed(std::uint32_t index) {
    index ^= (index >> 16);
    index ^= (index >> 8) & 0x00ff00ffu;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 1) & 0x55555555u;
    return index;
}

/// A dimension of Sobol's sequence at the index of one byte alone, reversed: [place of the
/// byte][byte].
using ByteTables = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr ByteTables tables_of(const std::array<std::uint32_t, 32>& direction_numbers) {
    ByteTables tables{};
    for (std::size_t bit = 0; bit < 32; ++bit)
        for (std::size_t byte = 0; byte < 256; ++byte)
            if (byte >> (bit % 8) & 1)
                tables[bit / 8][byte] ^= reverse_bits(direction_numbers[bit] << (31 - bit));
    return tables;
}
/// Primitive polynomial x² + x + 1. [Joe & Kuo 2008, d = 3: s = 2, a = 1, m = 1, 3]
constexpr ByteTables make_sobol_2() {
    std::array<std::uint32_t, 32> m{1, 3};
    for (std::size_t k = 2; k < 32; ++k) m[k] = (m[k - 1] << 1) ^ (m[k - 2] << 2) ^ m[k - 2];
    return tables_of(m);
}
/// Primitive polynomial x³ + x + 1. [Joe & Kuo 2008, d = 4: s = 3, a = 1, m = 1, 3, 1]
constexpr ByteTables make_sobol_3() {
    std::array<std::uint32_t, 32> m{1, 3, 1};
    for (std::size_t k = 3; k < 32; ++k) m[k] = (m[k - 2] << 2) ^ (m[k - 3] << 3) ^ m[k - 3];
    return tables_of(m);
}
constexpr ByteTables kSobol2 = make_sobol_2(), kSobol3 = make_sobol_3();

constexpr std::uint32_t look_up(const ByteTables& tables, std::uint32_t index) {
    return tables[0][index & 0xff] ^ tables[1][index >> 8 & 0xff] ^ tables[2][index >> 16 & 0xff] ^
           tables[3][index >> 24];
}

constexpr double number_of_reversed(std::uint32_t x) {
    return static_cast<double>(reverse_bits(x)) * 0x1p-32;
}

/// A place of its own for each (vertex, purpose), of which two steps are taken.
constexpr std::uint64_t place_of(std::uint32_t vertex, Purpose purpose) {
    return ((std::uint64_t{vertex} << 8) | static_cast<std::uint32_t>(purpose)) << 1;
}

}  // namespace

/// Of splitmix64.
std::uint64_t SampleKey::step(std::uint64_t number) const {
    return mix_bits(stream_ + kGolden * number);
}

/// Sobol's first dimension is the index reversed, and both scrambles want a reversed number: the
/// shuffle's result is used as it is.
std::uint32_t SampleKey::shuffled(std::uint64_t first_step) const {
    return reverse_bits(
        scramble_reversed(reverse_bits(index_), static_cast<std::uint32_t>(first_step >> 32)));
}

std::array<double, 2> SampleKey::two(std::uint32_t vertex, Purpose purpose) const {
    const std::uint64_t place = place_of(vertex, purpose);
    const std::uint32_t index = shuffled(step(place + 1));
    const std::uint64_t b = step(place + 2);
    const std::uint64_t x = scramble_reversed(index, static_cast<std::uint32_t>(b));
    const std::uint64_t y =
        scramble_reversed(sobol_1_reversed(index), static_cast<std::uint32_t>(b >> 32));
    const std::uint64_t both = reverse_bits_of_halves((y << 32) | x);
    return {static_cast<double>(static_cast<std::uint32_t>(both)) * 0x1p-32,
            static_cast<double>(both >> 32) * 0x1p-32};
}

double SampleKey::third(std::uint32_t vertex, Purpose purpose) const {
    const std::uint64_t a = step(place_of(vertex, purpose) + 1);
    return number_of_reversed(
        scramble_reversed(look_up(kSobol2, shuffled(a)), static_cast<std::uint32_t>(a)));
}

double SampleKey::fourth(std::uint32_t vertex, Purpose purpose) const {
    const std::uint64_t a = step(place_of(vertex, purpose) + 1);
    return number_of_reversed(
        scramble_reversed(look_up(kSobol3, shuffled(a)), static_cast<std::uint32_t>(mix_bits(a))));
}

}  // namespace dewbow
