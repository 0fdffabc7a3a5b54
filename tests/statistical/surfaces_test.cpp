// SPDX-License-Identifier: Apache-2.0

// Every kind of rough surface: it samples by its density, is reciprocal, and loses and gains no
// light that it should not. The same tests find faults planted into each of them.

#include <gtest/gtest.h>

#include "../analytic/statistics.h"
#include "chi_square.h"
#include "surfaces.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kDirections = 200000;
constexpr double kCosines[] = {0.95, 0.3};
/// Two-sided false alarms of 1e-6 a mean.
constexpr double kSigmas = 4.89;

/// Both sides of a surface that differs from side to side.
std::vector<std::function<SeenSurface(Vec3)>> sides(const SurfaceRow& row) {
    if (row.index == 1.0) return {row.from_above};
    return {row.from_above, row.from_below};
}

ChiSquare distribution(const SeenSurface& surface) {
    return chi_square(
        [&](const SampleKey& key) {
            return surface.sample(test_numbers(key, 0)[0], test_numbers(key, 1));
        },
        [&](Vec3 d) { return surface.eval(d).pdf; }, kDirections);
}

/// The largest difference of f(x → y) and f(y → x), relative; of light that goes through, of
/// radiance by the square of the index.
double irreciprocity(const SurfaceRow& row) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 4000; ++i) {
        const SampleKey key = independent_key(31, i);
        const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
        const Vec3 x = sample_cosine_hemisphere(a[0], a[1]).v;
        Vec3 y = sample_cosine_hemisphere(b[0], b[1]).v;
        const bool through = row.transmits && i % 2 == 0;
        if (through) y.z = -y.z;
        const double there = row.from_above(x).eval(y).f_cos / std::abs(y.z);
        // From below everything is seen upside down.
        const double back = through
                                ? row.from_below({y.x, y.y, -y.z}).eval({x.x, x.y, -x.z}).f_cos *
                                      row.index * row.index / x.z
                                : row.from_above(y).eval(x).f_cos / x.z;
        if (there == 0.0 && back == 0.0) continue;
        worst = std::max(worst, std::abs(there - back) / std::max(there, back));
    }
    return worst;
}

MeanSums albedo(const SeenSurface& surface, int directions = kDirections) {
    MeanSums sums;
    for (std::size_t i = 0; i < std::size_t(directions); ++i) {
        const SampleKey key = independent_key(32, i);
        const auto d = surface.sample(test_numbers(key, 0)[0], test_numbers(key, 1));
        const SeenSurface::Value value = d ? surface.eval(*d) : SeenSurface::Value{};
        sums.add(value.pdf > 0.0 ? value.f_cos / value.pdf : 0.0);
    }
    return sums;
}

bool within(const MeanSums& found, const SurfaceRow& row) {
    const double slack = row.tables + kSigmas * found.standard_error();
    return found.mean() > row.least_albedo - slack && found.mean() < row.most_albedo + slack;
}

TEST(Surfaces, SampleByTheirDensity) {
    for (const SurfaceRow& row : all_surfaces())
        for (const auto& side : sides(row))
            for (const double cosine : kCosines) {
                const ChiSquare found = distribution(side(tilted(cosine)));
                EXPECT_LT(found.score, kChiLimit) << row.name << " " << cosine;
                EXPECT_FALSE(found.in_void) << row.name << " " << cosine;
                EXPECT_LE(found.integral, 1.0 + kQuadrature) << row.name << " " << cosine;
            }
}

/// Rounding; of Fresnel's factor next to total reflection.
constexpr double kReciprocal = 1e-6;

TEST(Surfaces, AreReciprocal) {
    for (const SurfaceRow& row : all_surfaces())
        EXPECT_LT(irreciprocity(row), kReciprocal) << row.name;
}

TEST(Surfaces, KeepEnergy) {
    for (const SurfaceRow& row : all_surfaces())
        for (const auto& side : sides(row))
            for (const double cosine : {1.0, 0.5, 0.05}) {
                const MeanSums found = albedo(side(tilted(cosine)));
                EXPECT_TRUE(within(found, row)) << row.name << " " << cosine << ": " << found.mean()
                                                << " ± " << found.standard_error();
            }
}

/// Roughness 0, as a texture may hold it, is the least there is; and grazing is no special case.
TEST(Surfaces, NearlySmoothOnesKeepEnergyToo) {
    const auto white = make_constant(1.0);
    for (const double roughness : {0.0, 0.02, 0.15}) {
        MetallicRoughness varnished{white, 1.0, 0.0};
        varnished.clearcoat = 1.0, varnished.clearcoat_roughness = roughness;
        const SurfaceRow rows[] = {
            row_of("metal", {"", MetallicRoughness{white, 1.0, roughness}}, 1.0, 1.0),
            row_of("plastic", {"", MetallicRoughness{white, 0.0, roughness}}, 1.0, 1.0),
            row_of("varnished metal", {"", varnished}, 0.9, 1.0),
            row_of("pane",
                   {"", ThinDielectric{make_dispersion({"constant", {1.5}}), nullptr, roughness}},
                   1.0, 1.0),
            row_of_glass("glass", roughness, 1.5, 1.0, 1.0),
            row_of_glass("out of glass", roughness, 1.0 / 1.5, 1.0, 1.0)};
        for (const SurfaceRow& row : rows)
            for (const double cosine : {0.9, 0.2, 1e-3, 1e-12}) {
                const MeanSums found = albedo(row.from_above(tilted(cosine)), kDirections / 10);
                EXPECT_TRUE(within(found, row))
                    << row.name << " " << roughness << " " << cosine << ": " << found.mean();
            }
    }
}

// ---- planted faults ----------------------------------------------------------------------------

/// `row` with the value of what `from_above` and `from_below` give changed by `change`, which knows
/// the direction that the surface is looked at from.
using Change = std::function<void(Vec3 wo, Vec3 wi, SeenSurface::Value& value)>;
SurfaceRow planted(SurfaceRow row, const Change& change) {
    const auto wrap = [&](std::function<SeenSurface(Vec3)> from) {
        return [from, change](Vec3 wo) {
            SeenSurface surface = from(wo);
            surface.eval = [wo, change, eval = surface.eval](Vec3 wi) {
                SeenSurface::Value value = eval(wi);
                change(wo, wi, value);
                return value;
            };
            return surface;
        };
    };
    row.from_above = wrap(row.from_above), row.from_below = wrap(row.from_below);
    return row;
}

/// A density 5 % too small on one half of the directions and too large on the other.
TEST(Surfaces, WrongDensitiesAreSeen) {
    for (const SurfaceRow& row : all_surfaces()) {
        const SurfaceRow wrong = planted(row, [](Vec3, Vec3 wi, SeenSurface::Value& value) {
            value.pdf *= wi.x > 0.0 ? 1.05 : 0.95;
        });
        EXPECT_GT(distribution(wrong.from_above(tilted(0.95))).score, kChiLimit) << row.name;
    }
}

/// One part in a hundred thousand that depends on one of the two directions alone.
TEST(Surfaces, OneSidedFactorsAreSeen) {
    for (const SurfaceRow& row : all_surfaces())
        EXPECT_GT(irreciprocity(planted(row,
                                        [](Vec3 wo, Vec3, SeenSurface::Value& value) {
                                            value.f_cos *= 1.0 + 1e-5 * wo.z;
                                        })),
                  kReciprocal)
            << row.name;
}

/// 2 % too dark or too bright, where a surface is to be exactly white.
TEST(Surfaces, SmallLossesAndGainsAreSeen) {
    int white = 0;
    for (const SurfaceRow& row : all_surfaces()) {
        if (row.least_albedo < 1.0) continue;
        ++white;
        for (const double factor : {0.98, 1.02}) {
            const SurfaceRow wrong =
                planted(row, [&](Vec3, Vec3, SeenSurface::Value& value) { value.f_cos *= factor; });
            EXPECT_FALSE(within(albedo(wrong.from_above(tilted(0.5))), wrong))
                << row.name << " " << factor;
        }
    }
    EXPECT_GE(white, 9);
}

}  // namespace
}  // namespace dewbow
