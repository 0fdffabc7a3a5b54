// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/rain_law.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <limits>

/// The same text in single precision, as shaders have it.
namespace single_law {
using real = float;
using std::abs;
using std::exp;
using std::log;
using std::max;
using std::min;
inline float max(double a, float b) { return std::max(float(a), b); }
#define RAIN_LAW inline
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#include "dewbow/sky/rain_law.inl"
#pragma GCC diagnostic pop
#undef RAIN_LAW
}  // namespace single_law

namespace dewbow {
namespace {

using namespace rain_law;

/// Some roundings of a double.
constexpr double kRelative = 2e-15;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const std::vector<double> kSizes{1e-300, 1e-20, 1e-9, 1e-3, 0.1,  0.2499, 0.2501, 0.4999,
                                 0.5,    0.7,   1.0,  3.0,  10.0, 50.0,   400.0};

TEST(RainLaw, MeansAreThoseOfExtendedPrecision) {
    for (const double x : kSizes) {
        for (const double signed_x : {x, -x}) {
            const long double expected = -std::expm1l(-(long double)(signed_x)) / signed_x;
            EXPECT_NEAR(rain_mean_transmittance(signed_x) / double(expected), 1.0, kRelative) << x;
        }
        EXPECT_NEAR(rain_opacity(x) / double(-std::expm1l(-(long double)(x))), 1.0, kRelative);
        if (x >= 1.0) continue;
        const long double expected = -std::log1pl(-(long double)(x)) / x;
        EXPECT_NEAR(rain_mean_logarithm(x) / double(expected), 1.0, kRelative) << x;
    }
    EXPECT_EQ(rain_mean_transmittance(0.0), 1.0);
    EXPECT_EQ(rain_mean_logarithm(0.0), 1.0);
}

TEST(RainLaw, APieceIsTheDifferenceOfItsEnds) {
    for (const double depth : {0.0, 0.3, 5.0}) {
        for (const double change : kSizes) {
            for (const double length : {1e-3, 40.0}) {
                const double rate = change / length;
                const long double grows =
                    std::exp(-(long double)(depth)) * -std::expm1l(-(long double)(change)) / rate;
                EXPECT_NEAR(rain_piece(depth, rate, length) / double(grows), 1.0, kRelative);
                // Backwards the same.
                EXPECT_NEAR(rain_piece(depth + change, -rate, length) / double(grows), 1.0,
                            (1.0 + depth + change) * kRelative);
            }
        }
    }
    EXPECT_EQ(rain_piece(0.5, 0.0, 3.0), 3.0 * std::exp(-0.5));
    EXPECT_EQ(rain_piece(0.0, 0.25, kInfinity), 4.0);
}

TEST(RainLaw, ThePlaceOfAShareHoldsThatShare) {
    constexpr double kPlace = 1e-12;  // of the whole piece
    for (const double change : kSizes) {
        for (const double sign : {1.0, -1.0}) {
            const double length = 7.0, rate = sign * change / length;
            const double depth = sign < 0.0 ? change : 0.0;
            const double whole = rain_piece(depth, rate, length);
            double last = 0.0;
            for (const double u : {0.0, 1e-12, 0.1, 0.5, 0.9, 1.0 - 1e-12}) {
                const double place = rain_piece_place(rate, length, u);
                EXPECT_GE(place, last);
                EXPECT_LE(place, length);
                EXPECT_NEAR(rain_piece(depth, rate, place) / whole, u, kPlace)
                    << change * sign << " " << u;
                last = place;
            }
        }
    }
    EXPECT_NEAR(rain_piece_place(0.25, kInfinity, 0.5), 4.0 * std::log(2.0), kRelative * 4.0);
}

// Depths that no real rain has, but that a slip of the pen writes into a file.
TEST(RainLaw, HugeAndTinyDepthsStayNumbers) {
    for (const double depth : {0.0, 1e-300, 1e9, 1e300}) {
        for (const double rate : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
            for (const double length : {1e-300, 1.0, 1e7}) {
                const double piece = rain_piece(depth, rate, length);
                EXPECT_TRUE(std::isfinite(piece) && piece >= 0.0 && piece <= length);
                for (const double u : {0.0, 0.5, 1.0 - DBL_EPSILON / 2}) {
                    for (const double signed_rate : {rate, -rate}) {
                        const double place = rain_piece_place(signed_rate, length, u);
                        EXPECT_TRUE(place >= 0.0 && place <= length) << signed_rate << " " << u;
                    }
                }
            }
        }
        EXPECT_LE(rain_endless(depth), 1.0);
        EXPECT_LE(rain_antisolar(depth), 0.5);
    }
    EXPECT_EQ(rain_antisolar(kInfinity), 0.5);
    EXPECT_EQ(rain_transmittance(1e9), 0.0);
}

TEST(RainLaw, SlabsOfOneDepthAreOnePiece) {
    for (const double depth : {1e-8, 0.1, 1.0, 5.0, 80.0}) {
        for (const double slant : {0.0, 0.5, 1.0, 20.0}) {
            const double metres = 30.0, extinction = depth / metres;
            const double piece = rain_piece(0.0, extinction * (1.0 + slant), metres);
            EXPECT_NEAR(rain_slab(depth, slant) / (extinction * piece), 1.0, kRelative);
        }
        EXPECT_EQ(rain_endless(depth), rain_slab(depth, 0.0));
    }
}

TEST(RainLaw, SinglePrecisionAgrees) {
    constexpr double kSingle = 2e-6;  // some roundings of a float
    for (const double change : {1e-9, 1e-3, 0.1, 0.3, 0.6, 4.0, 60.0}) {
        EXPECT_NEAR(
            single_law::rain_piece(0.2f, float(change), 1.0f) / rain_piece(0.2, change, 1.0), 1.0,
            kSingle);
        EXPECT_NEAR(single_law::rain_piece_place(float(change), 1.0f, 0.4f) /
                        rain_piece_place(change, 1.0, 0.4),
                    1.0, 2.0 * kSingle);
        EXPECT_NEAR(single_law::rain_slab(float(change), 1.0f) / rain_slab(change, 1.0), 1.0,
                    kSingle);
    }
}

}  // namespace
}  // namespace dewbow
