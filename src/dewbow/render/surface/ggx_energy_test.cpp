// SPDX-License-Identifier: Apache-2.0

#include "dewbow/render/surface/ggx_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/render/surface/microfacet_oracle.h"

namespace dewbow {
namespace {

using oracle::mean_over_visible, oracle::tilted;

constexpr double kPi = std::numbers::pi;

double seen_on_the_way_out(Vec3 wo, Vec3 m, double alpha) {
    const Vec3 wi = m * (2.0 * dot(wo, m)) - wo;
    return wi.z > 0.0 ? ggx_g1(wi, alpha) : 0.0;
}

/// Smith's shadowing leaves as much area of microfacets as there is of the surface.
TEST(Ggx, VisibleAreaIsThatOfTheSurface) {
    for (const double alpha : {0.01, 0.1, 0.5, 1.0})
        for (const double cosine : {1.0, 0.7, 0.2}) {
            const double area = mean_over_visible(tilted(cosine), alpha, [](Vec3) { return 1.0; });
            EXPECT_NEAR(area, 1.0, oracle::kError) << alpha << " " << cosine;
        }
}

TEST(GgxEnergy, IsThatOfAnIntegral) {
    double worst = 0.0, worst_grazing = 0.0;
    for (const double roughness : {0.05, 0.11, 0.2, 0.33, 0.5, 0.72, 0.9, 1.0})
        for (const double cosine : {1.0, 0.83, 0.6, 0.41, 0.2, 0.1, 0.05, 0.02}) {
            const double alpha = roughness * roughness;
            const Vec3 wo = tilted(cosine);
            const double albedo = mean_over_visible(
                wo, alpha, [&](Vec3 m) { return seen_on_the_way_out(wo, m, alpha); });
            const double grazing = mean_over_visible(wo, alpha, [&](Vec3 m) {
                return seen_on_the_way_out(wo, m, alpha) * std::pow(1.0 - dot(wo, m), 5.0);
            });
            const GgxAlbedo found = GgxEnergy(alpha).at(cosine);
            worst = std::max(worst, std::abs(1.0 - found.lost - albedo));
            worst_grazing = std::max(worst_grazing, std::abs(found.grazing - grazing));
            EXPECT_NEAR(1.0 - found.lost, albedo, kGgxEnergyError) << alpha << " " << cosine;
            EXPECT_NEAR(found.grazing, grazing, kGgxEnergyError) << alpha << " " << cosine;
        }
    std::printf("    largest error: E %.1e, grazing part %.1e\n", worst, worst_grazing);
}

/// What the second lobe gives back is what the first one lost.
TEST(GgxEnergy, IsWholeWithTheSecondLobe) {
    constexpr int kSteps = 20000;
    double worst = 0.0;
    for (double alpha = kLeastAlpha; alpha <= 1.0; alpha = std::min(alpha * 1.1, alpha + 0.013)) {
        const GgxEnergy energy(alpha);
        double given = 0.0;  // of a lost part of 1
        for (int i = 0; i < kSteps; ++i) {
            const LogAxis axis(alpha);
            const double cosine = axis.value((i + 0.5) / kSteps);
            given += 2.0 * kPi * energy.compensation(1.0, energy.at(cosine).lost, cosine) *
                     axis.slope(cosine) / kSteps;
        }
        for (const double cosine : {1.0, 0.5, 0.1, 0.01, 1e-4}) {
            const double lost = energy.at(cosine).lost;
            worst = std::max(worst, std::abs(lost * (given - 1.0)));
            EXPECT_NEAR(1.0 - lost + lost * given, 1.0, kGgxEnergyError)
                << alpha << " " << cosine << " " << given;
        }
    }
    std::printf("    largest error of the sum: %.1e\n", worst);
}

/// Microfacets that reflect all light give all of it back; dark ones next to nothing twice.
TEST(GgxEnergy, MultipleReflections) {
    const GgxEnergy energy(0.64);
    EXPECT_DOUBLE_EQ(energy.multiple(1.0), 1.0);
    EXPECT_NEAR(energy.multiple(0.01), 1e-4 * (1.0 - energy.average().lost), 1e-6);
    // The series itself.
    double series = 0.0, left = 1.0, f = 0.7;
    for (int bounce = 2; bounce < 200; ++bounce) {
        series += std::pow(f, bounce) * (1.0 - energy.average().lost) * left;
        left *= energy.average().lost;
    }
    EXPECT_NEAR(energy.multiple(f), series, 1e-12);
}

TEST(GgxEnergy, SmoothSurfacesLoseNothing) {
    const GgxEnergy energy(kLeastAlpha);
    for (const double cosine : {1.0, 0.5, 0.1}) EXPECT_LT(energy.at(cosine).lost, 1e-5);
    // (1 − cos θ)⁵ of a mirror; a tilt of 1e-4 moves it by less.
    EXPECT_NEAR(energy.at(0.5).grazing, 1.0 / 32.0, kGgxEnergyError);
}

}  // namespace
}  // namespace dewbow
