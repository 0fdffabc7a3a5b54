// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/drop_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
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

/// Drops of 0.5 mm by rays, made once.
DropCloudPtr rays() {
    static const DropCloudPtr cloud = make_drop_cloud(request_of("0.5mm", "descartes"));
    return cloud;
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
    const DropCloudPtr cloud = rays();
    ASSERT_EQ(cloud->discs().size(), 2u);
    // Floats, and the midpoint rule at the bow's edge.
    for (const double integral : integral_over_sphere(*cloud, 0)) EXPECT_NEAR(integral, 1.0, 1e-4);
    for (const double integral : integral_over_sphere(*cloud, 1)) EXPECT_NEAR(integral, 1.0, 1e-3);
}

// Against the table itself, at angles and wavelengths between those that the cloud keeps: what is
// lost by straight lines between them, and by averaging over the disc afterwards.
TEST(DropCloud, IsTheTable) {
    /// Of the larger of the value and the primary bow's peak.
    constexpr double kInterpolation = 0.01;
    const DropCloudRequest request = request_of("normal:mean=0.5mm,width=10%");
    const auto cloud = make_drop_cloud(request);
    TableRequest exact;
    exact.sizes = request.showers.front();
    exact.optics = request.optics;
    const std::vector<double> lambdas = {431.7, 487.3, 552.4, 623.1, 702.6};
    for (const double lambda : lambdas) exact.wavelengths.push_back(lambda * nm);
    for (double theta = 60.013; theta < 175.0; theta += 0.117) exact.angles.push_back(theta * deg);
    const ScatteringTable table = make_scattering_table(exact);
    std::vector<double> extinction(lambdas.size()), albedo(lambdas.size());
    cloud->extinction_lanes(lambdas, extinction);
    cloud->albedo_lanes(lambdas, albedo);
    const double section = cloud->drops_per_m3() * table.mean_cross_section.to(m * m);  // per m³
    double worst = 0.0;
    std::vector<Intensities> got(lambdas.size());
    for (std::size_t j = 0; j < lambdas.size(); ++j) {
        // Scattering per metre and sr of both, so that the forward cut makes no difference.
        const double per_metre =
            section * table.efficiencies[j].scattering / (4.0 * std::numbers::pi);
        double peak = 0.0;
        for (std::size_t a = 0; a < exact.angles.size(); ++a)
            if (exact.angles[a] > 130.0 * deg)
                peak = std::max(peak, per_metre * table.at(a, j).unpolarised());
        for (std::size_t a = 0; a < exact.angles.size(); ++a) {
            cloud->phase_lanes(std::cos(exact.angles[a].to(rad)), 1, lambdas, got);
            const double is = extinction[j] * albedo[j] * got[j].unpolarised();
            const double should = per_metre * table.at(a, j).unpolarised();
            worst = std::max(worst, std::abs(is - should) / std::max(should, peak));
        }
    }
    EXPECT_LT(worst, kInterpolation);
}

// sample_cosine is the inverse of the integral of cosine_pdf.
TEST(DropCloud, SamplesAreInProportionToTheDensity) {
    const DropCloudPtr cloud = rays();
    constexpr int kSteps = 200000;
    double below = 0.0;
    int checked = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double from = std::cos(std::numbers::pi * i / kSteps),
                     to = std::cos(std::numbers::pi * (i + 1) / kSteps);
        const double density = cloud->cosine_pdf(0.5 * (from + to));
        EXPECT_GT(density, 0.0);
        below += 2.0 * std::numbers::pi * density * (from - to);
        if (i % 1000 != 999) continue;
        // Back by the density to the angle that holds the same share.
        const double cosine = cloud->sample_cosine(below);
        EXPECT_NEAR((cosine - to) * 2.0 * std::numbers::pi * density, 0.0, 2e-5);
        ++checked;
    }
    EXPECT_EQ(checked, 200);
    EXPECT_NEAR(below, 1.0, 1e-4);
}

double efficiency_at_550nm(const DropCloudRequest& request) {
    const auto cloud = make_drop_cloud(request);
    const double lambda = 550.0;
    double extinction = 0.0;
    cloud->extinction_lanes({&lambda, 1}, {&extinction, 1});
    return extinction /
           (cloud->drops_per_m3() * mean_cross_section(*request.showers.front()).to(m * m));
}

// Large drops take twice their cross section out of a beam, half of it by diffraction (Babinet). Of
// that, 1 − J_0² − J_1² goes on within xθ, which is 1 − 2 / (π x θ) for large ones: 1.3 % of the
// cross section remain at 0.5 mm. Edges add 1.99 x^{−2/3} to each half.   [Nussenzveig & Wiscombe
// 1980]
TEST(DropCloud, DiffractionAroundRainGoesStraightOn) {
    const double x = 2.0 * std::numbers::pi * 0.5e-3 / 550e-9;
    const double remains = 2.0 / (std::numbers::pi * x * kForwardCut.to(rad));
    const double edge = 1.99 * std::pow(x, -2.0 / 3.0);
    EXPECT_NEAR(efficiency_at_550nm(request_of("normal:mean=0.5mm,width=10%")),
                1.0 + remains + 0.5 * edge, 0.01);
    // Coronas of fog are as wide as hands.
    EXPECT_NEAR(
        efficiency_at_550nm(request_of("gamma:effective-radius=5um,effective-variance=0.1")), 2.1,
        0.1);
}

TEST(DropCloud, TwoShowersAreTheMeanOfEach) {
    DropCloudRequest request = request_of("0.3mm", "descartes");
    const DropCloudPtr one = rays();
    request.showers.push_back(parse_drop_sizes("1mm"));
    const auto both = make_drop_cloud(request);
    // Rays know no sizes, but for the angles at which the tables stand.
    std::vector<Intensities> a(kLanes.size()), b(kLanes.size());
    for (const double degrees : {60.0, 90.0, 110.0, 160.0}) {
        one->phase_lanes(std::cos(degrees / 180.0 * std::numbers::pi), 1, kLanes, a);
        both->phase_lanes(std::cos(degrees / 180.0 * std::numbers::pi), 1, kLanes, b);
        for (std::size_t k = 0; k < kLanes.size(); ++k)
            EXPECT_NEAR(a[k].unpolarised() / b[k].unpolarised(), 1.0, 0.01) << degrees;
    }
    EXPECT_NE(one->identity(), both->identity());
}

TEST(DropCloud, WhatIsNoRainIsRefused) {
    const auto refused = [](const DropCloudRequest& request) {
        try {
            make_drop_cloud(request);
            return std::string();
        } catch (const InputError& error) {
            return error.sentence();
        }
    };
    EXPECT_EQ(refused({}), "no drop sizes");
    EXPECT_NE(refused(request_of("0.5mm", "airy")).find("near its bows only"), std::string::npos);
    DropCloudRequest water = request_of("0.5mm", "descartes");
    water.amount = RainExtinction{1e3};
    EXPECT_NE(refused(water).find("would fill"), std::string::npos);
    EXPECT_NE(refused(request_of("1cm", "descartes")).find("break up"), std::string::npos);
}

}  // namespace
}  // namespace dewbow
