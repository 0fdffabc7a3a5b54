// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/random.h"
#include "dewbow/math/distribution.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/punctual_light.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
/// Sums of a thousand products of ten roundings.
constexpr double kRounding = 1e-12;

std::array<double, 2> numbers(std::size_t i, std::uint32_t which) {
    return SampleKey(stream_key(7, std::uint32_t(i), 0), 0).two(which, Purpose::test);
}
Vec3 direction(std::size_t i, std::uint32_t which) {
    const auto u = numbers(i, which);
    return sample_uniform_sphere<World>(u[0], u[1]).v;
}
/// In the cube of side 2 `half` around the origin.
Vec3 place(std::size_t i, std::uint32_t which, double half) {
    const auto a = numbers(i, which), b = numbers(i, which + 1);
    return half * Vec3{2.0 * a[0] - 1.0, 2.0 * a[1] - 1.0, 2.0 * b[0] - 1.0};
}

/// Spots of all kinds of cones in a cube, some of them black.
std::vector<SpotLight> random_spots(std::size_t count) {
    std::vector<SpotLight> spots;
    for (std::size_t i = 0; i < count; ++i) {
        const auto u = numbers(i, 10), v = numbers(i, 11);
        const Angle outer = (0.5 + 89.5 * u[0]) * unit::deg;
        spots.push_back({{place(i, 12, 5.0)},
                         {direction(i, 14)},
                         u[1] * 0.99 * outer,
                         outer,
                         make_constant(i % 17 == 3 ? 0.0 : std::exp(6.0 * v[0]))});
    }
    return spots;
}
std::vector<LightBounds> bounds_of(const std::vector<SpotLight>& spots) {
    std::vector<LightBounds> bounds;
    for (const SpotLight& spot : spots) bounds.push_back(PunctualLight(spot).bounds());
    return bounds;
}

Receiver receiver(std::size_t i, double half) {
    return {place(i, 20, half), i % 2 ? direction(i, 22) : Vec3{}};
}

/// Over lamps that shine everywhere; over spots less is left where a way ends before lights that
/// all shine elsewhere.
TEST(LightTree, ProbabilitiesSumToOne) {
    for (const std::size_t count : {1, 2, 3, 100, 1000}) {
        const std::vector<SpotLight> spots = random_spots(count);
        std::vector<LightBounds> lamps;
        for (const SpotLight& spot : spots)
            lamps.push_back(PunctualLight(PointLight{spot.position, spot.intensity}).bounds());
        const LightTree tree(lamps), tree_of_spots(bounds_of(spots));
        for (std::size_t i = 0; i < 40; ++i) {
            double sum = 0.0, sum_of_spots = 0.0;
            for (std::size_t k = 0; k < count; ++k) {
                sum += tree.probability({place(i, 20, 8.0)}, int(k));
                sum_of_spots += tree_of_spots.probability(receiver(i, 8.0), int(k));
            }
            EXPECT_NEAR(sum, 1.0, kRounding) << count << " lights";
            EXPECT_LE(sum_of_spots, 1.0 + kRounding);
        }
    }
}

/// What is chosen has the probability that it says, and each has its share of [0, 1).
TEST(LightTree, ChoosesByItsProbabilities) {
    constexpr int kSteps = 20000;
    const LightTree tree(bounds_of(random_spots(200)));
    for (std::size_t i = 0; i < 10; ++i) {
        const Receiver at = receiver(i, 8.0);
        std::vector<double> found(200, 0.0);
        for (int k = 0; k < kSteps; ++k) {
            const auto choice = tree.sample(at, (k + 0.5) / kSteps);
            if (!choice) continue;
            found[std::size_t(choice->light)] += 1.0 / kSteps;
            ASSERT_EQ(choice->probability, tree.probability(at, choice->light));
        }
        // An interval of [0, 1) holds the midpoints of its length but for one at either end.
        for (int k = 0; k < 200; ++k)
            ASSERT_NEAR(found[std::size_t(k)], tree.probability(at, k), 2.0 / kSteps);
    }
}

/// Every light that arrives can be chosen; black ones never are. (With the cosine at the receiver,
/// or that at the light, taken to the centre of the ball alone, it turns red.)
TEST(LightTree, StarvesNoLight) {
    const std::vector<SpotLight> spots = random_spots(1000);
    const LightTree tree(bounds_of(spots));
    int arrived = 0;
    for (std::size_t i = 0; i < 300; ++i) {
        const Receiver at = receiver(i, 8.0);
        for (std::size_t k = 0; k < spots.size(); ++k) {
            const double probability = tree.probability(at, int(k));
            const bool black = spots[k].intensity->max_value() == 0.0;
            if (black) {
                ASSERT_EQ(probability, 0.0);
            }
            const auto arrival = PunctualLight(spots[k]).arrival(at.position);
            if (!arrival || black) continue;
            if (at.one_sided() && dot(arrival->direction, at.normal) <= 0.0) continue;
            ++arrived;
            ASSERT_GT(probability, 0.0) << "light " << k;
        }
    }
    EXPECT_GT(arrived, 10000);
}

/// Two lamps alike: the choice is as their irradiance, 1 / d².
TEST(LightTree, WeighsByTheSquareOfTheDistance) {
    constexpr double kSingle = 1e-6;  // nodes are single precision
    std::vector<LightBounds> bounds;
    for (const double x : {1.0, 3.0})
        bounds.push_back(PunctualLight(PointLight{{{x, 0, 0}}, make_constant(2.0)}).bounds());
    const LightTree tree(bounds);
    EXPECT_NEAR(tree.probability({{}}, 0), 0.9, kSingle);
    // One of them from the side: times the cosine.
    const Receiver aside{{1, 1, 0}, {0, -1, 0}};
    const double there = std::sqrt(0.2) / 5.0;
    EXPECT_NEAR(tree.probability(aside, 0), 1.0 / (1.0 + there), kSingle);
}

TEST(LightTree, TakesManyLightsInOnePlace) {
    std::vector<LightBounds> bounds(
        5000, PunctualLight(PointLight{{{1, 2, 3}}, make_constant(1.0)}).bounds());
    const LightTree tree(bounds);
    EXPECT_NEAR(tree.probability({{}}, 4321), 1.0 / 5000.0, 1e-9);
    EXPECT_TRUE(LightTree({}).empty());
    EXPECT_FALSE(LightTree({}).sample({{}}, 0.5));
    bounds.assign(3, LightBounds{});
    EXPECT_TRUE(LightTree(bounds).empty());
    EXPECT_EQ(LightTree(bounds).probability({{}}, 1), 0.0);
}

/// The noise of one sample, Σ f² / p over (Σ f)² − 1, in a hall of lamps: a tenth of that of a
/// choice by power (116 against 1183 over these places). Both are sums, without chance.
TEST(LightTree, IsFarBetterThanPowerInAHall) {
    constexpr int kSide = 40;
    std::vector<PunctualLight> lamps;
    std::vector<LightBounds> bounds;
    std::vector<double> power;
    for (int i = 0; i < kSide * kSide; ++i) {
        power.push_back(std::exp(3.0 * numbers(std::size_t(i), 0)[0]));
        lamps.emplace_back(
            PointLight{{{double(i % kSide), 2.0, double(i / kSide)}}, make_constant(power.back())});
        bounds.push_back(lamps.back().bounds());
    }
    const LightTree tree(bounds);
    const Distribution1D by_power(power);
    double noise_tree = 0.0, noise_power = 0.0;
    for (std::size_t i = 0; i < 50; ++i) {
        const auto u = numbers(i, 1);
        const Receiver at{{kSide * u[0], 0.0, kSide * u[1]}, {0, 1, 0}};
        double sum = 0.0, squares_tree = 0.0, squares_power = 0.0;
        for (std::size_t k = 0; k < lamps.size(); ++k) {
            const auto arrival = lamps[k].arrival(at.position);
            const double f = power[k] * arrival->factor * arrival->direction.y;
            sum += f;
            squares_tree += f * f / tree.probability(at, int(k));
            squares_power += f * f / by_power.probability(k);
        }
        noise_tree += squares_tree / (sum * sum) - 1.0;
        noise_power += squares_power / (sum * sum) - 1.0;
    }
    EXPECT_LT(noise_tree, noise_power / 8.0) << noise_tree << " against " << noise_power;
}

TEST(DirectionCone, JoinHoldsBoth) {
    for (std::size_t i = 0; i < 2000; ++i) {
        const auto u = numbers(i, 0);
        const DirectionCone a{direction(i, 1), u[0] * kPi}, b{direction(i, 2), u[1] * u[1] * kPi};
        const DirectionCone both = join(a, b);
        ASSERT_NEAR(length(both.axis), 1.0, 1e-12);
        for (const DirectionCone& part : {a, b}) {
            const double apart = std::acos(std::clamp(dot(both.axis, part.axis), -1.0, 1.0));
            ASSERT_GE(both.half_angle_rad, std::min(kPi, apart + part.half_angle_rad) - 1e-7);
        }
        ASSERT_LE(both.half_angle_rad, kPi);
    }
    // Opposite ones hold everything.
    EXPECT_EQ(join(DirectionCone{{0, 0, 1}, 0.1}, DirectionCone{{0, 0, -1}, 0.1}).half_angle_rad,
              kPi);
}

/// The measure of emission against quadrature of its own definition.
TEST(LightBounds, EmissionMeasureIsItsIntegral) {
    for (const double normals : {0.0, 0.4, 1.3, 2.5, kPi})
        for (const double emission : {0.1, kPi / 2.0}) {
            constexpr int kSteps = 20000;
            double sum = 0.0;
            const double end = std::min(kPi, normals + emission);
            for (int i = 0; i < kSteps; ++i) {
                const double theta = end * (i + 0.5) / kSteps;
                const double cosine = theta < normals ? 1.0 : std::cos(theta - normals);
                sum += 2.0 * kPi * cosine * std::sin(theta) * end / kSteps;
            }
            LightBounds bounds;
            bounds.normals.half_angle_rad = normals;
            bounds.emission_rad = emission;
            EXPECT_NEAR(emission_measure(bounds), sum, 1e-6);
        }
}

}  // namespace
}  // namespace dewbow
