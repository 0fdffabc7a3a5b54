// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/conductor_fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/math/quadrature.h"
#include "dewbow/optics/metal.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

using unit::nm;

WavelengthPacket packet_around(double lambda_nm) {
    WavelengthPacket packet;
    packet.count = 5;
    for (int k = 0; k < 5; ++k) packet.lambda_nm[std::size_t(k)] = lambda_nm + 7.0 * (k - 2);
    return packet;
}
LaneValues all_lanes(double value) {
    LaneValues values;
    values.v.fill(value);
    return values;
}
Conductor conductor(const Metal& metal) { return {metal.n, metal.k, 0.5}; }

/// Against the careful form in optics; in water, too.
TEST(ConductorFresnel, IsThatOfOptics) {
    constexpr double kRounding = 1e-12;
    for (const Metal& metal : metal_catalogue())
        for (const double outside : {1.0, 1.33})
            for (double lambda = 380.0; lambda < 800.0; lambda += 60.0) {
                const WavelengthPacket packet = packet_around(lambda);
                const ConductorFresnel fresnel(conductor(metal), LaneSet::all(packet),
                                               all_lanes(outside));
                for (const double cosine : {0.0, 1e-3, 0.2, 0.5, 0.9, 1.0}) {
                    LaneValues found;
                    fresnel.at(cosine, found);
                    for (int k = 0; k < packet.count; ++k) {
                        const auto index = metal.index(packet.lambda_nm[std::size_t(k)] * nm);
                        EXPECT_NEAR(found[k],
                                    fresnel_conductor(cosine, index / outside).unpolarised(),
                                    kRounding)
                            << metal.name << " " << lambda << " " << cosine;
                    }
                }
            }
}

TEST(ConductorFresnel, AverageIsThatOfManyAngles) {
    const QuadratureRule rule = gauss_legendre(64);
    double worst = 0.0;
    for (const Metal& metal : metal_catalogue())
        for (double lambda = 380.0; lambda < 800.0; lambda += 30.0) {
            const ConductorFresnel fresnel(conductor(metal), LaneSet::all(packet_around(lambda)),
                                           all_lanes(1.0));
            LaneValues found, at;
            fresnel.average(found);
            const double expected = integrate(rule, 0.0, 1.0, [&](double mu) {
                fresnel.at(mu, at);
                return 2.0 * mu * at[0];
            });
            worst = std::max(worst, std::abs(found[0] - expected));
        }
    EXPECT_LT(worst, kAverageFresnelError);
    std::printf("    largest error: %.1e\n", worst);
}

/// Linear sRGB at normal incidence. [N. Hoffman, "Background: Physically-Based Shading", SIGGRAPH
/// 2010 course, table 1, of Real-Time Rendering, 3rd edition]
TEST(ConductorFresnel, MetalsHaveTheirColours) {
    // Their table is of older measurements (silver reflects more blue since) and is clamped.
    constexpr double kBetweenSources = 0.1;
    const struct {
        const char* name;
        Colour<LinearSrgb> expected;
    } rows[] = {{"gold", {{1.00, 0.71, 0.29}}},
                {"silver", {{0.95, 0.93, 0.88}}},
                {"copper", {{0.95, 0.64, 0.54}}},
                {"aluminium", {{0.91, 0.92, 0.92}}}};
    const SpectrumPtr daylight = find_illuminant("D65");
    for (const auto& row : rows) {
        const Metal& metal = find_metal(row.name);
        Colour<Xyz> sum{}, white{};
        for (double lambda = 380.0; lambda <= 780.0; lambda += 1.0) {
            const WavelengthPacket packet = packet_around(lambda);
            LaneValues f;
            ConductorFresnel(conductor(metal), LaneSet::all(packet), all_lanes(1.0)).at(1.0, f);
            const auto cie = cie_xyz_bar(lambda);
            const double light = (*daylight)(lambda * nm);
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += f[2] * light * cie[c];
                white[c] += light * cie[c];
            }
        }
        const auto found = rgb_from_xyz<LinearSrgb>(sum * (1.0 / white[1]));
        std::printf("    %s: %.3f %.3f %.3f\n", row.name, found[0], found[1], found[2]);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], row.expected[c], kBetweenSources) << row.name << " " << c;
    }
}

}  // namespace
}  // namespace dewbow
