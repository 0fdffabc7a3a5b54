// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/dielectric_energy.h"

#include <gtest/gtest.h>

#include <numbers>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/surface/microfacet_oracle.h"

namespace dewbow {
namespace {

using oracle::mean_over_visible, oracle::tilted;

/// What is shadowed on the way out, reflected or refracted. The refracted direction comes from
/// Snell's law for the tangential part.
double shadowed(Vec3 wo, Vec3 m, double alpha, double n) {
    const double cosine = std::min(1.0, dot(wo, m));
    const double r = fresnel_dielectric(cosine, n).unpolarised();
    const Vec3 reflected = m * (2.0 * cosine) - wo;
    double seen = reflected.z > 0.0 ? r * ggx_g1(reflected, alpha) : 0.0;
    const Vec3 tangential = (m * cosine - wo) / n;
    const double squared = dot(tangential, tangential);
    if (squared < 1.0) {
        const Vec3 refracted = tangential - m * std::sqrt(1.0 - squared);
        if (refracted.z < 0.0) seen += (1.0 - r) * ggx_g1(refracted, alpha);
    }
    return 1.0 - seen;
}

TEST(DielectricEnergy, IsThatOfAnIntegral) {
    double worst = 0.0;
    for (const double roughness : {0.15, 0.4, 0.63, 1.0})
        for (const double n : {1.33, 1.5, 1.9, 2.42, 1.0 / 1.33, 1.0 / 1.5, 1.0 / 2.42})
            for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
                const double alpha = roughness * roughness;
                const Vec3 wo = tilted(cosine);
                const double expected =
                    mean_over_visible(wo, alpha, [&](Vec3 m) { return shadowed(wo, m, alpha, n); });
                const double found = DielectricEnergy(alpha, n).lost_near(cosine);
                worst = std::max(worst, std::abs(found - expected));
                EXPECT_NEAR(found, expected, kDielectricEnergyError)
                    << alpha << " " << n << " " << cosine;
            }
    std::printf("    largest error: %.1e\n", worst);
}

/// Each side gives back what was lost, in shares between 0 and 1 that balance.
TEST(DielectricEnergy, IsWholeAndReciprocal) {
    constexpr int kSteps = 4000;
    double worst = 0.0;
    for (const double alpha : {1e-3, 0.01, 0.09, 0.2, 0.5, 0.77, 1.0})
        for (const double n : {1.01, 1.33, 1.5, 2.42, 1.0 / 1.5, 1.0 / 2.42}) {
            const DielectricEnergy energy(alpha, n), from_behind(alpha, 1.0 / n);
            const double share = energy.reflected_share();
            EXPECT_GE(share, 0.0);
            EXPECT_LE(share, 1.0);
            double given = 0.0;  // of a lost part of 1
            const LogAxis axis(alpha);
            for (int i = 0; i < kSteps; ++i) {
                const double mu = axis.value((i + 0.5) / kSteps);
                given += 2.0 * std::numbers::pi * axis.slope(mu) / kSteps *
                         (share * energy.compensation(1.0, energy.lost_near(mu), mu, true) +
                          (1.0 - share) * energy.compensation(1.0, energy.lost_far(mu), mu, false));
            }
            for (const double cosine : {1.0, 0.3, 0.02})
                worst = std::max(worst, std::abs(energy.lost_near(cosine) * (given - 1.0)));
            // Through: (1 − q) / L_avg of the far side, against the same from there.
            const double there = (1.0 - share) * energy.compensation(1.0, 1.0, 1.0, false);
            const double back = (1.0 - from_behind.reflected_share()) *
                                from_behind.compensation(1.0, 1.0, 1.0, false);
            EXPECT_NEAR(there / (n * n * back), 1.0, 1e-9) << alpha << " " << n;
        }
    EXPECT_LT(worst, kDielectricEnergyError);
    std::printf("    largest error of the sum: %.1e\n", worst);
}

}  // namespace
}  // namespace dewbow
