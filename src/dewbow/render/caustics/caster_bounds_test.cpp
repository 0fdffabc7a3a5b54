// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caster_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/caustics/directions_to.h"

namespace dewbow::caustics {
namespace {

constexpr double kPi = std::numbers::pi;
/// Some ten roundings.
constexpr double kRounding = 1e-13;
/// Of a bin's count against its expectation, in standard deviations: some thousand bins in all, of
/// which one is beyond by chance in 2000 runs.
constexpr double kSigmas = 5.2;

std::array<double, 2> numbers(int i, std::uint32_t which) {
    return SampleKey(stream_key(5, which, 0), std::uint32_t(i)).two(0, Purpose::test);
}
/// Independent of each other, so that counts scatter as they should.
std::array<double, 2> independent(int i, std::uint32_t which) {
    return SampleKey(stream_key(6, which, std::uint32_t(i)), 0).two(0, Purpose::test);
}
Vec3 direction(int i) {
    const auto u = numbers(i, 0);
    return sample_uniform_sphere<World>(u[0], u[1]).v;
}

OrientedBox test_box(Vec3 half) {
    const Affine turn = rotation(normalised(Vec3{1, 2, -1}), 1.1 * unit::rad);
    OrientedBox box;
    box.centre = {0.3, -0.2, 0.5};
    for (int axis = 0; axis < 3; ++axis)
        box.axes[std::size_t(axis)] = turn.apply_linear(
            {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
    box.half = half;
    return box;
}
bool meets(const CasterBounds& body, Vec3 origin, Vec3 d) {
    const auto crossing = body.crossing(origin, d);
    return crossing && crossing->t_out > 0.0;
}
std::vector<CasterBounds> bodies() {
    return {CasterBounds(test_box({1.0, 0.5, 0.2})), CasterBounds(test_box({0.7, 0.0, 0.4})),
            CasterBounds(Ball{{0.1, 0.2, 0.3}, 0.8})};
}

TEST(CasterBounds, ShowsACubeAsItsShadow) {
    OrientedBox cube;
    cube.half = {0.5, 0.5, 0.5};
    const auto shown = [&](Vec3 d) {
        return 1.0 / CasterBounds(cube).enter(normalised(d), {0.3, 0.4})->pdf;
    };
    EXPECT_NEAR(shown({0, -1, 0}), 1.0, kRounding);
    EXPECT_NEAR(shown({1, 1, 0}), std::sqrt(2.0), kRounding);
    EXPECT_NEAR(shown({1, 1, -1}), std::sqrt(3.0), kRounding) << "a regular hexagon";
}

/// A convex body shows a quarter of its surface on average. [Cauchy]
TEST(CasterBounds, ShowsAQuarterOfTheSurfaceOnAverage) {
    constexpr int kDirections = 4096;
    constexpr double kQuadrature = 2e-3;  // of even points over a function with creases
    for (const CasterBounds& body : bodies()) {
        double sum = 0.0;
        for (int i = 0; i < kDirections; ++i)
            sum += 1.0 / body.enter(direction(i), {0.5, 0.5})->pdf / kDirections;
        EXPECT_NEAR(sum / (0.25 * body.surface()), 1.0, kQuadrature);
    }
}

/// Points of entry, by uniform numbers, and of lines spread alike over a disc that holds the body
/// fall into the same cells alike.
TEST(CasterBounds, IsEnteredAlikeOverItsSilhouette) {
    constexpr int kSamples = 20000, kCells = 6;
    constexpr double kRadius = 1.6;
    for (const CasterBounds& body : bodies())
        for (int k = 0; k < 4; ++k) {
            const Vec3 d = direction(k);
            const Tangents across = tangents_of(d);
            std::array<double, kCells * kCells> entered{}, crossed{};
            const auto cell = [&](Vec3 p) {
                const auto along = [&](Vec3 axis) {
                    return std::clamp(int(kCells * (0.5 + 0.5 * dot(p, axis) / kRadius)), 0,
                                      kCells - 1);
                };
                return std::size_t(along(across.t) * kCells + along(across.b));
            };
            double lines = 0.0;
            const auto shown = 1.0 / body.enter(d, {0.5, 0.5})->pdf;
            for (int i = 0; i < kSamples; ++i) {
                entered[cell(body.enter(d, independent(i, 1))->point)] += 1.0;
                const auto u = independent(i, 2);
                const DiscPoint p = sample_concentric_disc(u[0], u[1]);
                const Vec3 start = (across.t * p.x + across.b * p.y) * kRadius - d * 9.0;
                if (!body.entry_of(start, d)) continue;
                EXPECT_TRUE(meets(body, start, d));
                crossed[cell(start)] += 1.0;
                lines += 1.0;
            }
            const double expected = kSamples * shown / (kPi * kRadius * kRadius);
            EXPECT_NEAR(lines, expected, kSigmas * std::sqrt(expected));
            for (std::size_t c = 0; c < entered.size(); ++c) {
                const double scale = lines / kSamples;
                const double sigma = std::sqrt(crossed[c] + scale * scale * entered[c] + 1.0);
                EXPECT_NEAR(scale * entered[c], crossed[c], kSigmas * sigma);
            }
        }
}

TEST(CasterBounds, FindsBackTheNumbersOfEntry) {
    std::vector<CasterBounds> all = bodies();
    all.emplace_back(EndlessPlane{{1, 2, 3}, normalised(Vec3{1, 1, 0.2}), 2.0});
    for (const CasterBounds& body : all)
        for (int i = 0; i < 200; ++i) {
            const Vec3 d = direction(i);
            const auto u = numbers(i, 3);
            const auto entry = body.enter(d, u);
            ASSERT_TRUE(entry);
            const auto back = body.entry_of(entry->point - d * 3.0, d);
            ASSERT_TRUE(back);
            constexpr double kGrazing = 1e-9;  // where the direction is nearly in a face
            EXPECT_NEAR(back->u[0], u[0], kGrazing);
            EXPECT_NEAR(back->u[1], u[1], kGrazing);
            EXPECT_NEAR(back->pdf / entry->pdf, 1.0, kGrazing);
        }
}

/// Half of the points lie within sqrt(3) reach, a quarter within sqrt(7)/3 reach.
TEST(CasterBounds, APlaneWithoutEndIsMetMostlyNearby) {
    constexpr int kSamples = 4096;
    constexpr double kQuadrature = 2e-3;
    const EndlessPlane plane{{1, 2, 3}, {0, 1, 0}, 0.5};
    double half = 0.0, quarter = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 p = CasterBounds(plane).enter({0, -1, 0}, numbers(i, 4))->point - plane.point;
        half += length(p) < std::sqrt(3.0) * plane.reach;
        quarter += length(p) < std::sqrt(7.0) / 3.0 * plane.reach;
    }
    EXPECT_NEAR(half / kSamples, 0.5, kQuadrature);
    EXPECT_NEAR(quarter / kSamples, 0.25, kQuadrature);
}

/// Of the directions that meet a body, seen from outside, each is found, as dense as all others;
/// and the solid angle is that which random directions find.
TEST(DirectionsTo, AreThoseThatMeetTheBody) {
    constexpr int kSamples = 20000;
    const Vec3 places[]{{3, 0.5, -1}, {0.3, -0.2, 2.0}, {-1.5, 1.0, 0.4}, {0.9, 1.0, 1.2}};
    for (const CasterBounds& body : bodies())
        for (const Vec3 from : places) {
            const auto to = DirectionsTo::from(from, body);
            ASSERT_TRUE(to);
            double met = 0.0;
            for (int i = 0; i < kSamples; ++i) {
                const auto u = independent(i, 5);
                const Vec3 d = sample_uniform_sphere<World>(u[0], u[1]).v;
                const auto place = to->place_of(d);
                ASSERT_EQ(bool(place), meets(body, from, d));
                if (!place) continue;
                met += 1.0;
                EXPECT_NEAR(place->pdf * to->solid_angle(), 1.0, kRounding);
                EXPECT_NEAR(length(to->sample(place->u).direction - d), 0.0, 1e-9);
            }
            const double expected = kSamples * to->solid_angle() * pdf_uniform_sphere();
            EXPECT_NEAR(met, expected, kSigmas * std::sqrt(expected));
        }
}

/// From afar faces are sampled by area: densities then integrate to 1 as they should.
TEST(DirectionsTo, AreAsDenseFromAfar) {
    constexpr double kDistance = 500.0;
    constexpr int kSamples = 4000;
    for (const CasterBounds& body : bodies()) {
        const Vec3 from = body.ball().centre + direction(3) * kDistance;
        const auto to = DirectionsTo::from(from, body);
        ASSERT_TRUE(to);
        // Directions alike in a cone around the body find its solid angle, and the mean density.
        const double width = 0.5 * std::pow(1.3 * body.ball().radius / kDistance, 2);
        const Dir<World> axis{normalised(body.ball().centre - from)};
        double density = 0.0, met = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const auto u = independent(i, 6);
            const auto place = to->place_of(around(axis, sample_uniform_cone(width, u[0], u[1])).v);
            if (!place) continue;
            met += 1.0 / kSamples, density += place->pdf / kSamples;
            const auto again = to->sample(place->u);
            EXPECT_NEAR(again.pdf / place->pdf, 1.0, 1e-6);
        }
        const double cone_sr = 1.0 / pdf_uniform_cone(width);
        const double sigma = std::sqrt((1.0 - met) / (met * kSamples));
        EXPECT_NEAR(density * cone_sr, 1.0, kSigmas * sigma);
        EXPECT_NEAR(met * cone_sr / to->solid_angle(), 1.0, kSigmas * sigma);
    }
}

TEST(DirectionsTo, AreNoneFromInside) {
    for (const CasterBounds& body : bodies()) {
        const Vec3 inside = body.ball().centre;
        EXPECT_FALSE(DirectionsTo::from(inside, body));
    }
    EXPECT_FALSE(DirectionsTo::from({0, 1, 0}, CasterBounds(EndlessPlane{{}, {0, 1, 0}, 1.0})));
}

}  // namespace
}  // namespace dewbow::caustics
