// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_claims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

/// Pearson's r of the n_d and 1/V_d that makers publish, about their means.
double published_correlation(std::string_view maker, std::size_t& count) {
    std::vector<double> n, w;
    for (const Glass& glass : glass_catalogue()) {
        if (!glass.name.starts_with(maker) || glass.v_d <= 0.0) continue;
        n.push_back(glass.n_d), w.push_back(1.0 / glass.v_d);
    }
    count = n.size();
    double n_mean = 0.0, w_mean = 0.0, nn = 0.0, nw = 0.0, ww = 0.0;
    for (std::size_t i = 0; i < count; ++i) n_mean += n[i] / count, w_mean += w[i] / count;
    for (std::size_t i = 0; i < count; ++i) {
        nn += (n[i] - n_mean) * (n[i] - n_mean);
        nw += (n[i] - n_mean) * (w[i] - w_mean);
        ww += (w[i] - w_mean) * (w[i] - w_mean);
    }
    return nw / std::sqrt(nn * ww);
}

// D for d, and the one or two glasses whose V_d is not published.
constexpr double kOfPublished = 5e-3;

TEST(PowerAndDensity, IsThatOfThePublishedNumbers) {
    for (const char* maker : {"schott/", "ohara/", "sumita/"}) {
        std::size_t count = 0;
        const double published = published_correlation(maker, count);
        const PowerAndDensity claim = power_and_density(maker);
        EXPECT_NEAR(claim.correlation, published, kOfPublished) << maker;
        EXPECT_NEAR(double(claim.glasses), double(count), 2.0) << maker;
    }
}

// The paper: "dispersive power is independent of optical density". Of glasses r is 0.65 to 0.87.
TEST(PowerAndDensity, GoTogether) {
    EXPECT_GT(power_and_density("schott/").correlation, 0.7);
    EXPECT_GT(power_and_density("").correlation, 0.5);
    EXPECT_EQ(power_and_density("nobody/").glasses, 0u);
    EXPECT_EQ(power_and_density("nobody/").correlation, 0.0);
}

}  // namespace
}  // namespace dewbow
