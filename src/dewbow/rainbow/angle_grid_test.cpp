// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/angle_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

TEST(AngleGrid, StraightLinesBetweenAnglesAreRight) {
    constexpr double kError = 0.003;  // as the header says
    TableRequest request;
    request.sizes = parse_drop_sizes("normal:mean=0.3mm,width=10%");
    request.optics = {make_dispersion({"constant", {1.333}, IndexReference::vacuum}), vacuum(),
                      0.0};
    request.wavelengths = {589.0 * nm};
    request.disc.radius = Angle{};
    AngleGrid grid{{1.333}, {1.333}};
    grid.x = request.optics.size_parameter(0.3 * mm, 589.0 * nm);
    grid.from = 20.0 * deg, grid.to = 175.0 * deg;
    const std::vector<Angle> coarse = adaptive_angles(grid);
    EXPECT_EQ(coarse.front(), grid.from);
    EXPECT_EQ(coarse.back(), grid.to);
    EXPECT_LT(coarse.size(), 1200u);
    for (std::size_t a = 0; a < coarse.size(); ++a) {
        request.angles.push_back(coarse[a]);
        if (a + 1 < coarse.size()) request.angles.push_back(0.5 * (coarse[a] + coarse[a + 1]));
    }
    const ScatteringTable table = make_scattering_table(request);
    double peak = 0.0;
    for (std::size_t a = 0; a < table.angles.size(); ++a)
        if (table.angles[a] > 137.0 * deg && table.angles[a] < 142.0 * deg)
            peak = std::max(peak, table.at(a, 0).unpolarised());
    for (std::size_t a = 1; a + 1 < table.angles.size(); a += 2) {
        const double at = table.at(a, 0).unpolarised();
        const double line =
            0.5 * (table.at(a - 1, 0).unpolarised() + table.at(a + 1, 0).unpolarised());
        EXPECT_NEAR(line, at, kError * std::max(at, peak)) << table.angles[a].to(deg);
    }
}

TEST(AngleGrid, IsFineAtTheAxisAndForFringes) {
    AngleGrid grid{{1.333}, {1.343}};
    grid.x = 1000.0;
    const std::vector<Angle> angles = adaptive_angles(grid);
    EXPECT_LE((angles[1] - angles[0]).to(rad), 0.5 / grid.x);
    EXPECT_LE((angles.back() - angles.end()[-2]).to(rad), 0.5 / grid.x);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end()));
    grid.fringes = true;
    const std::vector<Angle> fine = adaptive_angles(grid);
    for (std::size_t a = 1; a < fine.size(); ++a)
        EXPECT_LE((fine[a] - fine[a - 1]).to(rad), 1.6 / grid.x);
    const std::vector<Angle> few = {1.0 * deg, 2.0 * deg}, more = {2.0 * deg, 3.0 * deg};
    EXPECT_EQ(merged_angles(few, more).size(), 3u);
}

}  // namespace
}  // namespace dewbow
