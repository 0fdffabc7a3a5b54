// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/sheen_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// The fibres' value summed over directions alike; and none gives back more than it gets.
TEST(SheenLayer, AlbedoIsThatOfAnIntegral) {
    constexpr int kRings = 400, kSpokes = 100;
    double worst = 0.0, most = 0.0;
    for (const double roughness : {0.1, 0.25, 0.4, 0.66, 0.85, 1.0})
        for (const double cosine : {1.0, 0.77, 0.5, 0.31, 0.1, 0.02}) {
            const SheenLayer sheen({std::sqrt(1.0 - cosine * cosine), 0.0, cosine}, roughness);
            double sum = 0.0, kept = 0.0;
            for (int i = 0; i < kRings; ++i) {
                const double t = (i + 0.5) / kRings, z = t * t, r = std::sqrt(1.0 - z * z);
                for (int j = 0; j < kSpokes; ++j) {
                    const double phi = kPi * (j + 0.5) / kSpokes;
                    const Vec3 wi{r * std::cos(phi), r * std::sin(phi), z};
                    // With albedo_i = 0 it is divided by that of wo alone.
                    sum += 2.0 * t * sheen.eval(wi, 0.0) * std::max(1.0, sheen.albedo_o());
                    kept += 2.0 * t * sheen.eval(wi, sheen.albedo(z));
                }
            }
            const double expected = sum * 2.0 * kPi / (kRings * kSpokes);
            kept *= 2.0 * kPi / (kRings * kSpokes);
            EXPECT_LE(kept, 1.0 + kSheenAlbedoError) << roughness << " " << cosine;
            worst = std::max(worst, std::abs(sheen.albedo_o() - expected));
            most = std::max(most, expected);
            EXPECT_NEAR(sheen.albedo_o(), expected, kSheenAlbedoError)
                << roughness << " " << cosine;
        }
    std::printf("    largest error: %.1e; largest albedo %.3f\n", worst, most);
}

/// Seen from above by light from above, no fibre shows a face: D(z) = 0.
TEST(SheenLayer, FibresStandUpright) {
    const SheenLayer sheen({0.0, 0.0, 1.0}, 0.5);
    EXPECT_EQ(sheen.eval({0.0, 0.0, 1.0}, 0.0), 0.0);
    EXPECT_GT(sheen.eval({0.8, 0.0, 0.6}, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(sheen.leaves(0.0, 0.4), 1.0);
}

}  // namespace
}  // namespace dewbow
