// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/drop_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/optics/catalogue.h"
#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

DropCloudRequest request_of(const char* sizes, const char* model = "auto") {
    DropCloudRequest request;
    request.model = model;
    request.showers = {parse_drop_sizes(sizes)};
    request.optics = {make_dispersion(find_glass("water@20C").data),
                      make_dispersion(find_glass("air").data), 0.0};
    request.amount = RainExtinction{1e-3};
    request.discs = {SunDisc{}};
    return request;
}

const std::vector<double> kLanes = {400.0, 450.0, 500.0, 550.0, 589.3, 650.0, 700.0, 750.0};

/// ∫ over the sphere at each of kLanes, by midpoints in cosine and angle that know nothing of the
/// table's angles.
std::vector<double> integral_over_sphere(const DropCloud& cloud, std::size_t disc) {
    constexpr int kSteps = 40000;
    constexpr double kStep = std::numbers::pi / kSteps;
    std::vector<double> sums(kLanes.size());
    std::vector<Intensities> phase(kLanes.size());
    for (int i = 0; i < kSteps; ++i) {
        const double theta = (i + 0.5) * kStep;
        cloud.phase_lanes(std::cos(theta), disc, kLanes, phase);
        for (std::size_t k = 0; k < kLanes.size(); ++k)
            sums[k] += 2.0 * std::numbers::pi * std::sin(theta) * kStep * phase[k].unpolarised();
    }
    return sums;
}

TEST(DropCloud, PhaseIsAShare) {
    const auto cloud = make_drop_cloud(request_of("0.5mm", "descartes"));
    ASSERT_EQ(cloud->discs().size(), 2u);
    // Floats, and the midpoint rule at the bow's edge.
    for (const double integral : integral_over_sphere(*cloud, 0)) EXPECT_NEAR(integral, 1.0, 1e-4);
    for (const double integral : integral_over_sphere(*cloud, 1)) EXPECT_NEAR(integral, 1.0, 1e-3);
}

}  // namespace
}  // namespace dewbow
