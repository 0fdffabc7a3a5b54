// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dewbow {
namespace {

using Point = std::array<double, 2>;

// Keys are fixed, so that these tests always do the same: the false-alarm rates below are those of
// a change to the generator that leaves it as good as it is. Each statistic is asked for at this
// one-sided normal deviate, exceeded by chance with probability 1e-6; about 100 statistics are
// asked for.
constexpr double kDeviate = 4.7534;

/// The χ² of `counts` against equal expectation.
double chi_squared(const std::vector<int>& counts) {
    double total = 0.0, sum = 0.0;
    for (const int n : counts) total += n;
    const double expected = total / static_cast<double>(counts.size());
    for (const int n : counts) sum += (n - expected) * (n - expected) / expected;
    return sum;
}

/// The χ² that `cells` - 1 degrees of freedom exceed with probability 1e-6. [Wilson & Hilferty
/// 1931: within 2 % here]
double chi_squared_limit(std::size_t cells) {
    const double k = static_cast<double>(cells) - 1.0, v = 2.0 / (9.0 * k);
    return k * std::pow(1.0 - v + kDeviate * std::sqrt(v), 3.0);
}

/// How pairs of numbers in [0, 1), one a stream, fail to fill 16 × 16 cells evenly or to be
/// uncorrelated; empty if they do not.
///
/// 40,000 pairs: a relative excess of 10 % in half of the cells, or a correlation of 0.035, is
/// found with probability above 0.9.
std::string dependence_of(const std::function<Point(std::uint64_t)>& pair) {
    constexpr int kPairs = 40'000, kCells = 16;
    std::vector<int> counts(kCells * kCells);
    double correlation = 0.0;
    for (int i = 0; i < kPairs; ++i) {
        const Point p = pair(stream_key(1, static_cast<std::uint32_t>(i), 0));
        ++counts[static_cast<std::size_t>(p[0] * kCells) * kCells +
                 static_cast<std::size_t>(p[1] * kCells)];
        correlation += 12.0 * (p[0] - 0.5) * (p[1] - 0.5);
    }
    if (chi_squared(counts) > chi_squared_limit(counts.size()))
        return "chi-squared " + std::to_string(chi_squared(counts));
    // Each term has mean 0 and variance 1.
    if (std::abs(correlation) > kDeviate * std::sqrt(kPairs))
        return "correlation " + std::to_string(correlation / kPairs);
    return {};
}

/// `x` without its `bits` leading binary digits: what a scramble makes of the digits below.
double below(double x, int bits) {
    const double scaled = std::ldexp(x, bits);
    return scaled - std::floor(scaled);
}

TEST(MixBits, IsSplitMix) {
    // First three outputs of splitmix64 from seed 0. [Steele, Lea & Flood 2014; Vigna's
    // splitmix64.c]
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
    static_assert(mix_bits(1 * kGolden) == 0xe220a8397b1dcdafULL);
    static_assert(mix_bits(2 * kGolden) == 0x6e789e6aa1b965f4ULL);
    static_assert(mix_bits(3 * kGolden) == 0x06c45d188009454fULL);
}

TEST(StreamKey, PixelsAndSeedsDiffer) {
    std::set<std::uint64_t> keys;
    for (std::uint64_t seed : {0, 1, 2})
        for (std::uint32_t y = 0; y < 64; ++y)
            for (std::uint32_t x = 0; x < 64; ++x) keys.insert(stream_key(seed, x, y));
    EXPECT_EQ(keys.size(), 3u * 64u * 64u);
}

TEST(SampleKeyTest, SaysTheSameWheneverAsked) {
    const SampleKey key(stream_key(3, 10, 20), 17);
    const Point first = key.two(2, Purpose::lens);
    key.two(3, Purpose::test);
    EXPECT_EQ(key.two(2, Purpose::lens), first);
    EXPECT_EQ(SampleKey(stream_key(3, 10, 20), 17).two(2, Purpose::lens), first);
    EXPECT_EQ(key.one(2, Purpose::lens), first[0]);
    EXPECT_EQ(key.index(), 17u);
}

TEST(SampleKeyTest, EveryArgumentMatters) {
    const std::uint64_t stream = stream_key(3, 10, 20);
    const Point point = SampleKey(stream, 17).two(2, Purpose::lens);
    EXPECT_NE(SampleKey(stream + 1, 17).two(2, Purpose::lens), point);
    EXPECT_NE(SampleKey(stream, 18).two(2, Purpose::lens), point);
    EXPECT_NE(SampleKey(stream, 17).two(3, Purpose::lens), point);
    EXPECT_NE(SampleKey(stream, 17).two(2, Purpose::wavelength), point);
}

TEST(SampleKeyTest, NumbersAreThoseOfEveryEarlierRelease) {
    // A change here changes every picture: resumed and merged renders must then be refused.
    const Point point = SampleKey(stream_key(0, 0, 0), 0).two(0, Purpose::pixel_filter);
    EXPECT_EQ(point[0], 0x1.bbf8071cp-2);
    EXPECT_EQ(point[1], 0x1.3b6ba9b8p-2);
    const Point other = SampleKey(stream_key(7, 640, 480), 1000).two(3, Purpose::bsdf_direction);
    EXPECT_EQ(other[0], 0x1.c4ba4a8p-4);
    EXPECT_EQ(other[1], 0x1.c05051ecp-2);
    const SampleKey first(stream_key(0, 0, 0), 0), key(stream_key(7, 640, 480), 1000);
    EXPECT_EQ(first.third(0, Purpose::pixel_filter), 0x1.a633ed86p-1);
    EXPECT_EQ(first.fourth(0, Purpose::pixel_filter), 0x1.ea0fc7bp-3);
    EXPECT_EQ(key.third(3, Purpose::bsdf_direction), 0x1.8bbfc0ccp-2);
    EXPECT_EQ(key.fourth(3, Purpose::bsdf_direction), 0x1.b5a76944p-2);
}

TEST(SampleKeyTest, StaysBelowOneForExtremeArguments) {
    constexpr std::uint64_t kStreams[] = {0, 1, ~0ULL, 1ULL << 63, 0x9e3779b97f4a7c15ULL};
    constexpr std::uint32_t kWords[] = {0, 1, 0x7fffffffu, 0x80000000u, 0xfffffffeu, 0xffffffffu};
    for (const std::uint64_t stream : kStreams)
        for (const std::uint32_t index : kWords)
            for (const std::uint32_t vertex : kWords)
                for (const Purpose purpose : {Purpose::pixel_filter, Purpose::test})
                    for (const double u : SampleKey(stream, index).two(vertex, purpose)) {
                        ASSERT_GE(u, 0.0);
                        ASSERT_LT(u, 1.0);
                    }
    // The largest of all 32-bit fractions.
    static_assert(0xffffffffu * 0x1p-32 < 1.0);
}

/// Number of elementary intervals of volume 2^-m that do not hold exactly one of these 2^m points.
int faulty_intervals(const std::vector<Point>& points, int m) {
    int faults = 0;
    for (int a = 0; a <= m; ++a) {
        std::vector<int> counts(std::size_t{1} << m);
        for (const Point& p : points) {
            const auto column = static_cast<std::size_t>(std::ldexp(p[0], a));
            const auto row = static_cast<std::size_t>(std::ldexp(p[1], m - a));
            ++counts[(column << (m - a)) + row];
        }
        faults += static_cast<int>(
            std::count_if(counts.begin(), counts.end(), [](int n) { return n != 1; }));
    }
    return faults;
}

TEST(SampleKeyTest, EveryBlockFillsEveryElementaryInterval) {
    for (std::uint32_t k = 0; k < 16; ++k) {
        const std::uint64_t stream = stream_key(k, k, 2 * k);
        for (int m = 0; m <= 8; ++m) {
            const std::uint32_t size = 1u << m;
            // Whole multiples of the block, up to the last block of all.
            for (const std::uint32_t block : {0u, 1u, 2u, 3u, 77u, 0xffffffffu >> m}) {
                std::vector<Point> points;
                for (std::uint32_t i = 0; i < size; ++i)
                    points.push_back(SampleKey(stream, block * size + i).two(k, Purpose::test));
                ASSERT_EQ(faulty_intervals(points, m), 0) << "m " << m << " block " << block;
            }
        }
    }
}

TEST(SampleKeyTest, IntervalTestFindsAPlantedFault) {
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < 256; ++i) points.push_back(SampleKey(1, i).two(0, Purpose::test));
    std::swap(points[0][1], points[1][1]);
    EXPECT_GT(faulty_intervals(points, 8), 0);
}

/// Number of intervals of volume 2^-(m - t) with sides of powers of two that do not hold exactly
/// 2^t of these 2^m points, which come as 32-bit fractions.
template <std::size_t dimensions>
int uneven_intervals(const std::vector<std::array<double, dimensions>>& points, int m, int t) {
    int faults = 0;
    std::array<int, dimensions> sides{};  // 2^-side
    const std::function<void(std::size_t, int)> divide = [&](std::size_t d, int left) {
        if (d + 1 < dimensions) {
            for (sides[d] = 0; sides[d] <= left; ++sides[d]) divide(d + 1, left - sides[d]);
            return;
        }
        sides[d] = left;
        std::vector<int> counts(std::size_t{1} << (m - t));
        for (const auto& point : points) {
            std::size_t interval = 0;
            for (std::size_t i = 0; i < dimensions; ++i)
                interval = (interval << sides[i]) +
                           static_cast<std::size_t>(std::ldexp(point[i], sides[i]));
            ++counts[interval];
        }
        faults += static_cast<int>(
            std::count_if(counts.begin(), counts.end(), [&](int n) { return n != 1 << t; }));
    };
    divide(0, m - t);
    return faults;
}

TEST(SampleKeyTest, ThreeAndFourNumbersAreNetsTogether) {
    // The t of a Sobol' sequence is the sum of (degree − 1) over its primitive polynomials: of x +
    // 1, x² + x + 1 and x³ + x + 1 it is 0, 1 and 2. [Sobol' 1967] Scrambling keeps it. [Owen 1995]
    constexpr int kT3 = 1, kT4 = 3;
    for (const int m : {4, 7, 10})
        for (const std::uint32_t block : {0u, 3u, 77u}) {
            std::vector<std::array<double, 3>> three;
            std::vector<std::array<double, 4>> four;
            for (std::uint32_t i = 0; i < 1u << m; ++i) {
                const SampleKey key(stream_key(block, 5, 6), (block << m) + i);
                const auto [x, y] = key.two(7, Purpose::test);
                three.push_back({x, y, key.third(7, Purpose::test)});
                four.push_back({x, y, three.back()[2], key.fourth(7, Purpose::test)});
            }
            EXPECT_EQ(uneven_intervals(three, m, kT3), 0) << "m " << m << " block " << block;
            EXPECT_EQ(uneven_intervals(four, m, kT4), 0) << "m " << m << " block " << block;
            std::swap(three[0][2], three[1][2]);
            EXPECT_GT(uneven_intervals(three, m, kT3), 0) << "a planted fault, m " << m;
        }
}

TEST(SampleKeyTest, ThirdAndFourthAreScrambledOnTheirOwn) {
    for (const std::uint32_t index : {0u, 1u, 255u})
        for (const int i : {0, 1}) {
            const auto key = [=](std::uint64_t stream) { return SampleKey(stream, index); };
            EXPECT_EQ(dependence_of([&](std::uint64_t stream) {
                          return Point{key(stream).two(0, Purpose::test)[i],
                                       key(stream).third(0, Purpose::test)};
                      }),
                      "");
            EXPECT_EQ(dependence_of([&](std::uint64_t stream) {
                          return Point{key(stream).two(0, Purpose::test)[i],
                                       key(stream).fourth(0, Purpose::test)};
                      }),
                      "");
            EXPECT_EQ(dependence_of([&](std::uint64_t stream) {
                          return Point{key(stream).third(0, Purpose::test),
                                       key(stream).fourth(0, Purpose::test)};
                      }),
                      "");
        }
}

TEST(SampleKeyTest, OnePointIsUniformInTheSquare) {
    for (const std::uint32_t index : {0u, 1u, 2u, 255u, 0xffffffffu})
        EXPECT_EQ(dependence_of([=](std::uint64_t stream) {
                      return SampleKey(stream, index).two(0, Purpose::test);
                  }),
                  "");
}

TEST(SampleKeyTest, LowDigitsAreUniformToo) {
    for (const int bits : {4, 12, 20, 28})
        EXPECT_EQ(dependence_of([=](std::uint64_t stream) {
                      const Point p = SampleKey(stream, 5).two(0, Purpose::test);
                      return Point{below(p[0], bits), below(p[1], bits)};
                  }),
                  "");
}

TEST(SampleKeyTest, KeysAreIndependent) {
    const auto compare = [](auto first, auto second) {
        for (const int i : {0, 1})
            for (const int j : {0, 1})
                EXPECT_EQ(dependence_of([&](std::uint64_t stream) {
                              return Point{first(stream)[i], second(stream)[j]};
                          }),
                          "");
    };
    const auto at = [](std::uint32_t index, std::uint32_t vertex, Purpose purpose) {
        return [=](std::uint64_t stream) { return SampleKey(stream, index).two(vertex, purpose); };
    };
    const auto base = at(6, 1, Purpose::lens);
    compare(base, at(6, 2, Purpose::lens));
    compare(base, at(6, 1, Purpose::wavelength));
    compare(base,
            [](std::uint64_t stream) { return SampleKey(stream + 1, 6).two(1, Purpose::lens); });
    compare(base, [](std::uint64_t stream) {
        return SampleKey(stream ^ (1ULL << 63), 6).two(1, Purpose::lens);
    });
}

TEST(SampleKeyTest, SequencesOfTwoKeysAreIndependent) {
    // One stream, many indices: the shuffles of two keys must not run alongside.
    constexpr int kIndices = 1 << 16, kCells = 16;
    std::vector<int> counts(kCells * kCells);
    for (std::uint32_t i = 0; i < kIndices; ++i) {
        const SampleKey key(stream_key(9, 9, 9), i);
        const double x = key.one(0, Purpose::lens), y = key.one(1, Purpose::lens);
        ++counts[static_cast<std::size_t>(x * kCells) * kCells +
                 static_cast<std::size_t>(y * kCells)];
    }
    EXPECT_LT(chi_squared(counts), chi_squared_limit(counts.size()));
}

TEST(SampleKeyTest, DigitsBelowTheFirstThatDiffersAreIndependent) {
    // Owen's scramble: two points whose first k digits agree and whose next differ are independent
    // in all digits below. Indices 0 and 2^k are two such points in the first dimension, by the
    // shuffle in a random order, and in the second.
    for (const int k : {0, 1, 2, 3, 5, 8})
        for (const int dimension : {0, 1})
            EXPECT_EQ(dependence_of([=](std::uint64_t stream) {
                          const auto digits = [&](std::uint32_t index) {
                              const SampleKey key(stream, index);
                              return below(key.two(0, Purpose::test)[dimension], k + 1);
                          };
                          return Point{digits(0), digits(1u << k)};
                      }),
                      "");
}

TEST(SampleKeyTest, TheTwoDimensionsAreScrambledIndependently) {
    // The order in y of the four points of a block, taken in order of x. Of the 24 orders, the 16
    // that put a point into each quadrant occur, and by independent scrambles equally often. 40,000
    // blocks: an excess of 10 % in half of them is found with probability above 0.99; one scramble
    // for both leaves out 8.
    std::map<std::array<int, 4>, int> orders;
    for (std::uint32_t k = 0; k < 40'000; ++k) {
        std::array<Point, 4> points;
        for (std::uint32_t i = 0; i < 4; ++i)
            points[i] = SampleKey(stream_key(5, k, 0), i).two(0, Purpose::test);
        std::sort(points.begin(), points.end());
        std::array<int, 4> order;
        for (std::size_t i = 0; i < 4; ++i) order[i] = static_cast<int>(4.0 * points[i][1]);
        ++orders[order];
    }
    std::vector<int> counts;
    for (const auto& [order, count] : orders) counts.push_back(count);
    ASSERT_EQ(counts.size(), 16u);
    EXPECT_LT(chi_squared(counts), chi_squared_limit(counts.size()));
}

TEST(SampleKeyTest, IndependenceTestFindsPlantedFaults) {
    // Digital shift instead of Owen's scramble: one random number for all points.
    EXPECT_NE(dependence_of([](std::uint64_t stream) {
                  const double u = SampleKey(stream, 0).one(0, Purpose::test);
                  return Point{u, below(u + 0.5, 0)};
              }),
              "");
    // A tenth of the numbers shared by two keys.
    EXPECT_NE(dependence_of([](std::uint64_t stream) {
                  const SampleKey key(stream, 0);
                  const double u = key.one(0, Purpose::test);
                  return Point{u, stream % 10 == 0 ? u : key.one(1, Purpose::test)};
              }),
              "");
}

}  // namespace
}  // namespace dewbow
