// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/cloud_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

DispersionPtr constant(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

/// The angle at which light without polarisation is brightest.
Angle brightest(const ScatteringTable& table) {
    const auto better = [&](std::size_t a, std::size_t b) {
        return table.at(a, 0).unpolarised() < table.at(b, 0).unpolarised();
    };
    std::size_t best = 0;
    for (std::size_t a = 1; a < table.angles.size(); ++a)
        if (better(best, a)) best = a;
    return table.angles[best];
}

TEST(ShapedDrops, SpheresHaveNoShift) {
    const std::vector<WeightedRadius> radii = {{0.1 * mm, 0.5}, {0.5 * mm, 0.5}};
    for (const ShapedDrops& each : shape_drops(radii, {}, {1.33}, {1.34}))
        EXPECT_EQ(each.shift(2, 0.5), Angle{});
    const FallingShape falling{.spread = {.oscillation = 0.1, .tilt = 2.0 * deg}, .place = {}};
    double share = 0.0;
    for (const ShapedDrops& each : shape_drops(radii, falling, {1.33}, {1.34})) {
        EXPECT_EQ(each.shift(2, 0.0) > 1.0 * deg, each.radius == 1);
        share += radii[each.radius].share * each.share;
    }
    EXPECT_NEAR(share, 1.0, 1e-12);
}

TEST(ShapedDrops, TurnThePrimaryBowOfATableAndNotTheSecondary) {
    // 1 mm across, the sun on the horizon: 1.77° and 0.12° at the top.  [ray tracing in 2-D]
    constexpr double kPrimary = 1.77, kSecondary = 0.12, kStep = 0.02, kError = 0.04;
    for (const auto& [from, to, shift] :
         {std::tuple{136.0, 142.0, kPrimary}, std::tuple{126.0, 131.0, kSecondary}}) {
        TableRequest request;
        request.sizes = parse_drop_sizes("normal:mean=0.5mm,width=1%");
        request.optics = {constant(1.333), vacuum(), 0.0};
        request.wavelengths = {589.29 * nm};
        for (double theta = from; theta < to; theta += kStep) request.angles.push_back(theta * deg);
        const Angle sphere = brightest(make_scattering_table(request));
        request.falling = FallingShape{};
        const Angle oblate = brightest(make_scattering_table(request));
        EXPECT_NEAR(std::abs((oblate - sphere).to(deg)), shift, kError) << from;
    }
}

}  // namespace
}  // namespace dewbow
