// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/rain_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "dewbow/sky/rain_law.h"

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Distances of some hundred metres carry roundings of 1e-13 m; near a direction that runs along a
/// face they grow by the inverse of its cosine, which the random ones keep above 1e-3.
constexpr double kRounding_m = 1e-9;

struct Named {
    const char* name;
    ConvexRegion region;
};

std::vector<Named> regions() {
    const Affine turned = translation({3, 20, -40}) *
                          rotation(normalised({1, 2, 3}), 40.0 * unit::deg) * scaling({1, 2, 0.5});
    return {{"everywhere", ConvexRegion::everywhere()},
            {"layer", ConvexRegion::layer(-5.0 * unit::m, 30.0 * unit::m)},
            {"box", ConvexRegion::box(Transform<World, Object>(turned), {10, 12, 30})},
            {"curtain", ConvexRegion::curtain({{-40, 7, -30}}, {{50, 9, -60}}, 8.0 * unit::m,
                                              0.0 * unit::m, 60.0 * unit::m)}};
}

class Lines {
public:
    Vec3 place() { return {60.0 * unit_(random_), 60.0 * unit_(random_), 60.0 * unit_(random_)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v{unit_(random_), unit_(random_), unit_(random_)};
            const double size = length(v);
            if (size > 0.1 && size < 1.0) return v / size;
        }
    }
    double share() { return 0.5 + 0.5 * unit_(random_); }

private:
    std::mt19937_64 random_{20261127};
    std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

double length_by_cut(const ConvexRegion& region, Vec3 point, Vec3 towards) {
    const auto inside = region.cut({point}, {towards}, kInfinity);
    return inside ? inside->end - inside->begin : 0.0;
}

double length_by_pieces(const std::vector<LengthPiece>& pieces, double s) {
    for (const LengthPiece& piece : pieces) {
        if (s < piece.end || &piece == &pieces.back())
            return piece.length + piece.slope * (s - piece.begin);
    }
    return 0.0;
}

TEST(ConvexRegion, CutEndsWhereContainsDoes) {
    Lines lines;
    int met = 0;
    for (const auto& [name, region] : regions()) {
        for (int i = 0; i < 300; ++i) {
            const Vec3 from = lines.place(), d = lines.direction();
            const auto inside = region.cut({from}, {d}, 100.0);
            for (double s = 0.05; s < 100.0; s += 1.7) {
                const bool expected = inside && s > inside->begin && s < inside->end;
                EXPECT_EQ(region.contains({from + d * s}), expected)
                    << name << " " << i << " " << s;
            }
            met += inside.has_value();
        }
    }
    EXPECT_GT(met, 500);  // the lines do meet what they test
}

// The pieces against a cut from every point on its own.
TEST(ConvexRegion, LengthsTowardsADirectionAreExact) {
    Lines lines;
    for (const auto& [name, region] : regions()) {
        std::size_t most = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 from = lines.place(), d = lines.direction(), sun = lines.direction();
            std::vector<LengthPiece> pieces;
            region.lengths_towards({from}, {d}, {2.0, 150.0}, {sun}, pieces);
            ASSERT_FALSE(pieces.empty());
            EXPECT_EQ(pieces.front().begin, 2.0);
            EXPECT_EQ(pieces.back().end, 150.0);
            for (std::size_t k = 1; k < pieces.size(); ++k)
                EXPECT_EQ(pieces[k].begin, pieces[k - 1].end);
            for (int k = 0; k < 20; ++k) {
                const double s = 2.0 + 148.0 * lines.share();
                const double expected = length_by_cut(region, from + d * s, sun);
                const double found = length_by_pieces(pieces, s);
                if (expected == kInfinity) {
                    EXPECT_EQ(found, kInfinity) << name;
                } else {
                    EXPECT_NEAR(found, expected, kRounding_m * (1.0 + expected))
                        << name << " " << i;
                }
            }
            most = std::max(most, pieces.size());
        }
        EXPECT_GE(most, region.half_spaces().size() > 2 ? 5u : 1u) << name;
    }
}

TEST(ConvexRegion, ALevelSunEndsAtTheTopOfALayer) {
    const ConvexRegion layer = ConvexRegion::layer(0.0 * unit::m, 10.0 * unit::m);
    std::vector<LengthPiece> pieces;
    layer.lengths_towards({{0, -4, 0}}, {{0, 1, 0}}, {0.0, kInfinity}, {{1, 0, 0}}, pieces);
    ASSERT_EQ(pieces.size(), 3u);
    EXPECT_EQ(pieces[0].length, 0.0);
    EXPECT_EQ(pieces[1].begin, 4.0);
    EXPECT_EQ(pieces[1].length, kInfinity);
    EXPECT_EQ(pieces[2].begin, 14.0);
    EXPECT_EQ(pieces[2].length, 0.0);
}

TEST(ConvexRegion, ThicknessIsThatOfTheThinnestPair) {
    const auto found = [](const ConvexRegion& region) { return region.thickness()->to(unit::m); };
    const std::vector<Named> all = regions();
    EXPECT_FALSE(all[0].region.thickness());
    EXPECT_EQ(found(all[1].region), 35.0);
    EXPECT_NEAR(found(all[2].region), 20.0, kRounding_m);  // 2 · 10 m · 1
    EXPECT_NEAR(found(all[3].region), 8.0, kRounding_m);
}

/// ∫ e^{-σ (s - begin) - σ_sun ℓ(s)} ds by Simpson's rule on ever smaller intervals, ℓ by cuts.
double by_quadrature(const auto& integrand, double a, double b, double fa, double fm, double fb,
                     double tolerance, int depth) {
    const double m = 0.5 * (a + b), whole = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
    const double fl = integrand(0.5 * (a + m)), fr = integrand(0.5 * (m + b));
    const double halves = (b - a) / 12.0 * (fa + 4.0 * fl + 2.0 * fm + 4.0 * fr + fb);
    if (depth == 0 || std::abs(halves - whole) < 15.0 * tolerance)
        return halves + (halves - whole) / 15.0;
    return by_quadrature(integrand, a, m, fa, fl, fm, 0.5 * tolerance, depth - 1) +
           by_quadrature(integrand, m, b, fm, fr, fb, 0.5 * tolerance, depth - 1);
}

// The law in closed form against quadrature, at random lines through each region.
TEST(ConvexRegion, TheLawsIntegralIsThatOfAdaptiveQuadrature) {
    constexpr double kAccuracy = 1e-9;  // what the quadrature is asked for
    constexpr double kExtinction = 0.05, kLongest = 200.0;
    Lines lines;
    int met = 0;
    for (const auto& [name, region] : regions()) {
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = lines.place(), d = lines.direction(), sun = lines.direction();
            const auto inside = region.cut({from}, {d}, kLongest);
            if (!inside) continue;
            ++met;
            const double way =
                length_by_cut(region, from + d * (0.5 * (inside->begin + inside->end)), sun);
            const double sun_extinction = way == kInfinity ? 0.0 : kExtinction;
            std::vector<LengthPiece> pieces;
            region.lengths_towards({from}, {d}, *inside, {sun}, pieces);
            double found = 0.0;
            for (const LengthPiece& piece : pieces) {
                const double to_sun = sun_extinction > 0.0 ? sun_extinction * piece.length : 0.0;
                found += rain_law::rain_piece(kExtinction * (piece.begin - inside->begin) + to_sun,
                                              kExtinction + sun_extinction * piece.slope,
                                              piece.end - piece.begin);
            }
            const auto integrand = [&](double s) {
                const double to_sun =
                    sun_extinction > 0.0 ? sun_extinction * length_by_cut(region, from + d * s, sun)
                                         : 0.0;
                return std::exp(-kExtinction * (s - inside->begin) - to_sun);
            };
            const double a = inside->begin, b = inside->end, m = 0.5 * (a + b);
            const double expected = by_quadrature(integrand, a, b, integrand(a), integrand(m),
                                                  integrand(b), kAccuracy, 40);
            EXPECT_NEAR(found, expected, 20.0 * kAccuracy) << name << " " << i;
        }
    }
    EXPECT_GT(met, 300);
}

// A layer seen against the sun: light goes back by the way that it came, so that the integral of
// e^(−2t) over depths up to τ, (1 − e^(−2τ)) / 2, is found by way of regions and pieces.
TEST(ConvexRegion, TheAntisolarPointOfALayer) {
    const Vec3 sun = normalised({0.3, 0.5, 0.2});
    for (const double tau : {1e-6, 0.1, 1.0, 5.0, 1e9}) {
        const ConvexRegion layer = ConvexRegion::layer(0.0 * unit::m, 100.0 * unit::m);
        const double extinction = tau * sun.y / 100.0;
        const Vec3 eye{0, 300, 0};
        const auto inside = layer.cut({eye}, {-sun}, kInfinity);
        ASSERT_TRUE(inside);
        std::vector<LengthPiece> pieces;
        layer.lengths_towards({eye}, {-sun}, *inside, {sun}, pieces);
        ASSERT_EQ(pieces.size(), 1u);
        const double piece =
            rain_law::rain_piece(extinction * pieces[0].length,
                                 extinction * (1.0 + pieces[0].slope), inside->end - inside->begin);
        const double expected = -0.5 * std::expm1(-2.0 * tau);
        EXPECT_NEAR(extinction * piece / expected, 1.0, 1e-7)
            << tau;  // of τ = 1e9, 1e-16 of it is left out
        EXPECT_NEAR(rain_law::rain_antisolar(tau) / expected, 1.0, 1e-15);
    }
}

}  // namespace
}  // namespace dewbow
