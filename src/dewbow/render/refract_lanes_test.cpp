// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/refract_lanes.h"

#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {
namespace {

/// The SIMD form and the scalar one differ by rounding; next to total reflection cos θ_t is a root
/// of a small difference, and rounding counts for its square root.
constexpr double kReflectance = 1e-9;
constexpr double kNearTotal = 1e-6;  // of sin² θ_t
constexpr double kDirection = 1e-13;

TEST(RefractLanes, FollowSnellAndFresnel) {
    int reflected = 0, refracted = 0, total = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const SampleKey key(1, i);
        RayLanes rays;
        rays.count = kMaxLanes;
        BoundaryLanes boundary;
        std::array<Vec3, kMaxLanes> before{}, normal{};
        for (int k = 0; k < kMaxLanes; ++k) {
            const auto a = key.two(std::uint32_t(2 * k), Purpose::test),
                       b = key.two(std::uint32_t(2 * k + 1), Purpose::test);
            const Vec3 n = sample_uniform_sphere<World>(a[0], a[1]).v;
            // From normal to grazing incidence (cos² even).
            const Vec3 d = around(Dir<World>{-n}, sample_cosine_hemisphere(b[0], b[1])).v;
            const auto lane = std::size_t(k);
            before[lane] = d, normal[lane] = n;
            rays.set(k, {{}, d, {}});
            boundary.nx[k] = n.x, boundary.ny[k] = n.y, boundary.nz[k] = n.z;
            boundary.eta[k] =
                std::exp2(4.0 * key.two(100 + std::uint32_t(k), Purpose::test)[0] - 2.0);
        }
        const double u = key.one(200, Purpose::test);
        refract_or_reflect_lanes(kMaxLanes, u, rays, boundary);
        for (int k = 0; k < kMaxLanes; ++k) {
            const auto lane = std::size_t(k);
            const Vec3 d = before[lane], n = normal[lane],
                       after{boundary.dx[k], boundary.dy[k], boundary.dz[k]};
            const double cos_i = -dot(d, n), eta = boundary.eta[k];
            const double r = fresnel_dielectric(cos_i, eta).unpolarised();
            const double sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
            if (std::abs(1.0 - sin2_t) < kNearTotal || std::abs(u - r) < kReflectance) continue;
            ASSERT_NEAR(length(after), 1.0, kDirection);
            ASSERT_EQ(boundary.reflected[k], u < r ? 1.0 : 0.0);
            if (boundary.reflected[k] != 0.0) {
                ++reflected;
                total += sin2_t > 1.0;
                ASSERT_LT(length(after - (d + n * (2.0 * cos_i))), kDirection);
            } else {
                ++refracted;
                // Snell as vectors: n_i d × n = n_t d′ × n; and onwards, not back.
                ASSERT_LT(length(cross(d, n) - cross(after, n) * eta), 8.0 * kDirection);
                ASSERT_LT(dot(after, n), 0.0);
            }
        }
    }
    EXPECT_GT(reflected, 10000);
    EXPECT_GT(refracted, 10000);
    EXPECT_GT(total, 10000);
}

TEST(RefractLanes, TouchNoOtherLane) {
    RayLanes rays;
    rays.count = kMaxLanes;
    BoundaryLanes boundary;
    for (int k = 0; k < kMaxLanes; ++k) {
        rays.set(k, {{}, {0, 0, -1}, {}});
        boundary.nx[k] = 0.0, boundary.ny[k] = 0.6, boundary.nz[k] = 0.8, boundary.eta[k] = 1.5;
        boundary.dx[k] = 7.0;
    }
    refract_or_reflect_lanes(4, 0.9, rays, boundary);
    // Whole registers may be written, but not the one after.
    for (int k = 8; k < kMaxLanes; ++k) EXPECT_EQ(boundary.dx[k], 7.0) << k;
}

/// Exactly grazing rays and an index of 1 are numbers, too.
TEST(RefractLanes, EdgesAreFinite) {
    for (const double eta : {0.5, 1.0, 2.0})
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, normalised({1, 0, -1e-200})}) {
            RayLanes rays;
            rays.count = 1;
            rays.set(0, {{}, d, {}});
            BoundaryLanes boundary;
            boundary.nx[0] = 0, boundary.ny[0] = 0, boundary.nz[0] = 1, boundary.eta[0] = eta;
            refract_or_reflect_lanes(1, 0.5, rays, boundary);
            const Vec3 after{boundary.dx[0], boundary.dy[0], boundary.dz[0]};
            EXPECT_TRUE(is_finite(after));
            EXPECT_NEAR(length(after), 1.0, kDirection);
        }
}

}  // namespace
}  // namespace dewbow
