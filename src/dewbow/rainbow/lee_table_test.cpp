// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/lee_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

LeeRequest some_request() {
    LeeRequest request;
    request.width = 0.1;
    request.optics = {make_dispersion({"constant", {1.333}, IndexReference::vacuum}), vacuum(),
                      0.0};
    request.wavelengths = {500.0 * nm, 600.0 * nm};
    for (double theta = 120.0; theta <= 150.0; theta += 0.5) request.angles.push_back(theta * deg);
    return request;
}

TEST(LeeTable, EachRadiusIsTheTableOfItsDrops) {
    /// Of the peak: the tolerance, and corrections that go straight between radii.
    constexpr double kError = 0.04;
    LeeRequest request = some_request();
    for (double r = 20.0; r <= 500.0; r *= 2.2) request.radii.push_back(r * um);
    const LeeTable lee = make_lee_table(request);
    EXPECT_LE(lee.stated_error, request.tolerance);
    for (std::size_t r = 0; r < request.radii.size(); r += 2) {
        TableRequest one;
        one.model = "auto";
        one.sizes = gamma_drop_sizes(request.radii[r], request.width);
        one.optics = request.optics;
        one.wavelengths = {request.wavelengths[1]};
        one.angles = request.angles;
        one.disc = request.disc;
        const ScatteringTable table = make_scattering_table(one);
        double peak = 0.0;
        for (std::size_t a = 0; a < table.angles.size(); ++a)
            peak = std::max(peak, table.at(a, 0).unpolarised());
        for (std::size_t a = 0; a < table.angles.size(); ++a)
            EXPECT_NEAR(lee.at(r, a, 1).unpolarised(), table.at(a, 0).unpolarised(), kError * peak)
                << request.radii[r].to(um) << " um, " << table.angles[a].to(deg);
    }
}

TEST(LeeTable, LookupGoesStraightBetweenItsPoints) {
    LeeTable table;
    table.radii = {0.1 * mm, 0.4 * mm};
    table.angles = {130.0 * deg, 140.0 * deg};
    table.wavelengths = {400.0 * nm, 600.0 * nm};
    for (int k = 0; k < 8; ++k) table.phase.push_back({double(k), 10.0 * k});
    EXPECT_DOUBLE_EQ(table.lookup(0.1 * mm, 130.0 * deg, 400.0 * nm).perpendicular, 0.0);
    EXPECT_DOUBLE_EQ(table.lookup(0.4 * mm, 140.0 * deg, 600.0 * nm).parallel, 70.0);
    // Halfway in all three, the radius by its logarithm: the mean of 0 to 7.
    EXPECT_NEAR(table.lookup(0.2 * mm, 135.0 * deg, 500.0 * nm).perpendicular, 3.5, 1e-12);
    // Beyond the ends.
    EXPECT_DOUBLE_EQ(table.lookup(1.0 * mm, 10.0 * deg, 900.0 * nm).perpendicular, 5.0);
}

TEST(LeeTable, RefusesWhatIsNoRequest) {
    const auto refused = [](auto change) {
        LeeRequest request = some_request();
        request.radii = {0.1 * mm, 0.2 * mm};
        change(request);
        EXPECT_THROW((void)make_lee_table(request), InputError);
    };
    refused([](LeeRequest& r) { r.radii.clear(); });
    refused([](LeeRequest& r) { r.radii = {0.2 * mm, 0.1 * mm}; });
    refused([](LeeRequest& r) { r.radii = {std::nan("") * mm}; });
    refused([](LeeRequest& r) { r.width = -0.1; });
    refused([](LeeRequest& r) { r.width = 1.5; });
    refused([](LeeRequest& r) { r.optics.around = nullptr; });
    refused([](LeeRequest& r) { r.wavelengths.clear(); });
    refused([](LeeRequest& r) { r.angles.clear(); });
}

}  // namespace
}  // namespace dewbow
