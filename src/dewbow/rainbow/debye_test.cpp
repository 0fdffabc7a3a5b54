// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/debye.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr RelativeIndex kWater{1.333};
const std::vector<Angle> kAngles = {0.0 * deg, 41.7 * deg, 90.0 * deg, 137.9 * deg, 180.0 * deg};

std::unique_ptr<ScatteringModel> debye_model(Orders orders) {
    ModelOptions options;
    options.orders = std::move(orders);
    return make_scattering_model("debye", options);
}

std::vector<Amplitudes> amplitudes_of(Orders orders, const Drop& drop) {
    const auto model = debye_model(std::move(orders));
    std::vector<Amplitudes> result(kAngles.size());
    dynamic_cast<const AmplitudeModel&>(*model).amplitudes(kWater, drop, kAngles, result);
    return result;
}

/// Largest |S − S'|.
double distance(const std::vector<Amplitudes>& u, const std::vector<Amplitudes>& v) {
    double largest = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        largest = std::max({largest, std::abs(u[i].perpendicular - v[i].perpendicular),
                            std::abs(u[i].parallel - v[i].parallel)});
    }
    return largest;
}

std::string refusal(ComplexIndex index, const Drop& drop, Orders orders = {}) {
    try {
        debye_model(std::move(orders))->efficiencies(index, drop);
    } catch (const InputError& error) {
        return error.sentence();
    }
    return {};
}

TEST(DebyeModel, OrdersAreSummedAsAmplitudes) {
    constexpr double kRounding = 1e-11;
    const Drop drop{500.0};
    const std::vector<Amplitudes> two = amplitudes_of({2}, drop), three = amplitudes_of({3}, drop);
    std::vector<Amplitudes> sum = two;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i].perpendicular += three[i].perpendicular;
        sum[i].parallel += three[i].parallel;
    }
    EXPECT_LT(distance(amplitudes_of({3, 2, 3}, drop), sum), kRounding);
    EXPECT_GT(distance(two, sum), 1.0);
}

TEST(DebyeModel, IntensitiesAreSquaredAmplitudesOfEachDrop) {
    const std::vector<Drop> drops = {{20.0}, {300.0}};
    std::vector<Intensities> intensities(drops.size() * kAngles.size());
    debye_model({1})->intensities(kWater, drops, kAngles, intensities);
    for (std::size_t d = 0; d < drops.size(); ++d) {
        const std::vector<Amplitudes> s = amplitudes_of({1}, drops[d]);
        for (std::size_t i = 0; i < kAngles.size(); ++i) {
            const Intensities& here = intensities[d * kAngles.size() + i];
            EXPECT_NEAR(here.perpendicular, std::norm(s[i].perpendicular),
                        1e-12 * here.perpendicular);
            EXPECT_NEAR(here.parallel, std::norm(s[i].parallel), 1e-12 * here.parallel);
        }
    }
}

TEST(DebyeModel, SharesOfTheExtinctionAddUp) {
    // Over p = 0…400 in a drop of x = 20; what is left, 4e-5, are waves that pass it by.
    constexpr double kLeft = 1e-4;
    double sum = 0.0;
    for (int p = 0; p <= 400; ++p) sum += debye_model({p})->efficiencies(kWater, {20.0}).extinction;
    const Efficiencies all = debye_model({})->efficiencies(kWater, {20.0});
    EXPECT_NEAR(sum, all.extinction, kLeft);
    EXPECT_EQ(all.extinction, all.scattering);
    EXPECT_GT(debye_model({0})->efficiencies(kWater, {20.0}).extinction, 1.0);
}

TEST(DebyeModel, RefusesInOneSentence) {
    EXPECT_NE(refusal({1.333, 1e-6}, {100.0}).find("do not absorb"), std::string::npos);
    EXPECT_NE(refusal({0.75, 0.0}, {100.0}).find("index 0.75 of a drop"), std::string::npos);
    EXPECT_NE(refusal(kWater, {30000.0}).find("size parameter 30000 is outside"),
              std::string::npos);
    EXPECT_NE(refusal(kWater, {100.0}, {2, -1}).find("order -1"), std::string::npos);
    Drop flat{100.0};
    flat.shifts[2] = 1.0 * deg;
    EXPECT_NE(refusal(kWater, flat).find("for spheres"), std::string::npos);
    EXPECT_EQ(refusal(kWater, {100.0}, {0, 2, 40}), "");
}

}  // namespace
}  // namespace dewbow
