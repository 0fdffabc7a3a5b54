// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/descartes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/quadrature.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/geometric_flux.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;
constexpr RelativeIndex kWater{1.333};
/// Energy balances: sums of some thousand terms.
constexpr double kBalance = 1e-12;

std::vector<Angle> angles(double from, double to, double step) {
    std::vector<Angle> result;
    for (int k = 0; from + k * step <= to + 1e-9; ++k) result.push_back((from + k * step) * deg);
    return result;
}

std::vector<PolarisedFlux> flux(RelativeIndex n, int p, const std::vector<Angle>& edges) {
    std::vector<PolarisedFlux> cells(edges.size() - 1);
    add_geometric_flux(n, p, edges, cells);
    return cells;
}

PolarisedFlux sum_of(const std::vector<PolarisedFlux>& cells) {
    PolarisedFlux sum;
    for (const PolarisedFlux& cell : cells) {
        sum.perpendicular += cell.perpendicular;
        sum.parallel += cell.parallel;
    }
    return sum;
}

/// ∫ 2b ε² db by Gauss in the angle of incidence, with amplitudes by angles: another way than the
/// model's.
PolarisedFlux by_incidence(RelativeIndex n, int p, double b_from, double b_to) {
    static const QuadratureRule rule = gauss_legendre(96);
    PolarisedFlux sum;
    const double from = std::asin(b_from), to = std::asin(b_to), half = 0.5 * (to - from);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double i = from + half * (1.0 + rule.nodes[k]);
        const RayAmplitudes e = ray_amplitudes(drop_ray(std::sin(i), n), n, p);
        const double weight = half * rule.weights[k] * std::sin(2.0 * i);
        sum.perpendicular += weight * e.perpendicular * e.perpendicular;
        sum.parallel += weight * e.parallel * e.parallel;
    }
    return sum;
}

TEST(GeometricFlux, OfEachOrderIsAsTabulated) {
    // n = 1.333, of light polarised perpendicular and parallel: ∫ 2c ε² dc with 30 digits (mpmath).
    // In the mean .066406 .883698 .040597 .006119 .001723 .000670 .000314 .000167.
    const PolarisedFlux expected[] = {{0.101947513535550697, 0.0308640160306082371},
                                      {0.821815310710372049, 0.945579877853612475},
                                      {0.0616229844306968247, 0.0195707988952480857},
                                      {0.00968379762083706806, 0.00255413760543219991},
                                      {0.00268832224335438939, 0.000757272353861580444},
                                      {0.00103478525903021517, 0.000304555306668383104},
                                      {0.000482914180730112961, 0.000145507060261156124},
                                      {0.000255660707358601892, 0.0000780974359721395394}};
    for (int p = 0; p <= kHighestOrder; ++p) {
        const PolarisedFlux found = order_flux(kWater, p).flux;
        EXPECT_NEAR(found.perpendicular, expected[p].perpendicular, kBalance) << p;
        EXPECT_NEAR(found.parallel, expected[p].parallel, kBalance) << p;
    }
}

TEST(GeometricFlux, CellsKeepTheEnergyOfEachOrder) {
    for (double n : {1.02, 1.30, 1.333, 1.36, 1.9})
        for (int p = 0; p <= kHighestOrder; ++p)
            for (double step : {0.1, 1.0, 30.0, 180.0}) {
                const PolarisedFlux sum = sum_of(flux({n}, p, angles(0.0, 180.0, step)));
                const PolarisedFlux all = by_incidence({n}, p, 0.0, 1.0);
                EXPECT_NEAR(sum.perpendicular, all.perpendicular, kBalance) << n << " " << p;
                EXPECT_NEAR(sum.parallel, all.parallel, kBalance) << n << " " << p;
            }
}

TEST(GeometricFlux, CellWithTheBowHoldsTheRaysAroundIt) {
    // From the edge of the dark side to δ beyond the bow: the rays between the two that leave at δ.
    for (int p : {2, 3})  // from order 4 on other rays leave there too
        for (double delta : {1e-6, 0.05, 0.5}) {
            const DescartesRay bow = descartes_ray(kWater, p);
            const Angle bright = bow.scattering_angle + bow.bright_side * delta * deg;
            const Angle dark = bow.scattering_angle - bow.bright_side * delta * deg;
            std::vector<Angle> edges = {std::min(bright, dark), std::max(bright, dark)};
            // The two rays by their own search: bisection on the deflection.
            const auto ray_at = [&](double b_dark, double b_bright) {
                for (int k = 0; k < 200; ++k) {
                    const double b = 0.5 * (b_dark + b_bright);
                    const bool within =
                        (deviation(drop_ray(b, kWater), p) - bow.deviation) < delta * deg;
                    (within ? b_dark : b_bright) = b;
                }
                return b_dark;
            };
            const PolarisedFlux expected = by_incidence(
                kWater, p, ray_at(bow.impact_parameter, 0.0), ray_at(bow.impact_parameter, 1.0));
            const PolarisedFlux found = flux(kWater, p, edges)[0];
            // 1e-15 of the deflection moves b by 1e-15 / 2hδb.
            const double tolerance = delta < 1e-3 ? 1e-6 : 1e-10;
            EXPECT_NEAR(found.perpendicular / expected.perpendicular, 1.0, tolerance) << p;
            EXPECT_NEAR(found.parallel / expected.parallel, 1.0, tolerance) << p;
        }
}

TEST(GeometricFlux, AgreesWithManyRays) {
    // 400,000 rays evenly over b, weighted ε² 2b or ε²: the histogram that others make.
    constexpr int kRays = 400'000;
    // A cell's first and last ray: 4 / kRays of what the brightest cells hold, with a reserve.
    constexpr double kGrain = 2e-5;
    const std::vector<Angle> edges = angles(0.0, 180.0, 0.5);
    for (int p : {1, 2, 3, 6}) {
        std::vector<double> disc(edges.size() - 1), impact(edges.size() - 1);
        for (int k = 0; k < kRays; ++k) {
            const double b = (k + 0.5) / kRays;
            const DropRay ray = drop_ray(b, kWater);
            const RayAmplitudes e = ray_amplitudes(ray, kWater, p);
            const auto cell = std::size_t(scattering_angle(deviation(ray, p)).to(0.5 * deg));
            disc[cell] += 2.0 * b * e.perpendicular * e.perpendicular / kRays;
            impact[cell] += e.parallel * e.parallel / kRays;
        }
        const std::vector<PolarisedFlux> over_disc = flux(kWater, p, edges);
        std::vector<PolarisedFlux> over_impact(edges.size() - 1);
        add_geometric_flux(kWater, p, edges, over_impact, RayDensity::even_in_impact_parameter);
        for (std::size_t k = 0; k < disc.size(); ++k) {
            EXPECT_NEAR(over_disc[k].perpendicular, disc[k], kGrain) << p << " cell " << k;
            EXPECT_NEAR(over_impact[k].parallel, impact[k], kGrain) << p << " cell " << k;
        }
    }
}

TEST(Descartes, SmallCellsTendToTheRaysBrightness) {
    // The second difference over the cell, (10⁻⁴ rad)².
    constexpr double kCurvature = 1e-5;
    const auto model = make_descartes({});
    const Drop drop{500.0};
    for (double theta : {20.0, 60.0, 110.0, 133.0, 150.0}) {
        const std::vector<Angle> around = {(theta - 0.01) * deg, theta * deg, (theta + 0.01) * deg};
        std::vector<Intensities> out(3);
        model->intensities(kWater, {&drop, 1}, around, out);
        Intensities rays;
        for (int p = 0; p <= kHighestOrder; ++p) {
            const Intensities one = geometric_intensity(kWater, p, theta * deg);
            rays.perpendicular += one.perpendicular;
            rays.parallel += one.parallel;
        }
        EXPECT_NEAR(out[1].perpendicular / (500.0 * 500.0 * rays.perpendicular), 1.0, kCurvature);
        EXPECT_NEAR(out[1].parallel / (500.0 * 500.0 * rays.parallel), 1.0, kCurvature);
    }
}

TEST(Descartes, IntensitiesIntegrateToTheScatteringEfficiency) {
    // Q = (1 / πx²) ∫ |S|² dΩ over the cells, and g; for each order alone and for all.
    const std::vector<Angle> theta = angles(0.0, 180.0, 0.05);
    const std::vector<Angle> edges = cell_edges(theta);
    /// In the bow's cell the mean cosine is not that of the middle: by less than 0.025° in rad.
    constexpr double kMiddle = 1e-4;
    for (const Orders& orders : {Orders{}, {0}, {1}, {2}, {3}, {7}, {2, 3}}) {
        const auto model = make_descartes({orders, {}, 0.02});
        const Drop drop{1000.0};
        std::vector<Intensities> out(theta.size());
        model->intensities(kWater, {&drop, 1}, theta, out);
        double Q = 0.0, forward = 0.0;
        for (std::size_t k = 0; k < out.size(); ++k) {
            const double part = out[k].unpolarised() / (kPi * 1e6) *
                                cell_solid_angle(edges[k], edges[k + 1]).to(sr);
            Q += part;
            forward += part * cos(0.5 * (edges[k] + edges[k + 1]));
        }
        const Efficiencies efficiencies = model->efficiencies(kWater, drop);
        EXPECT_NEAR(Q, efficiencies.scattering, kBalance);
        EXPECT_NEAR(forward / Q, efficiencies.asymmetry, kMiddle);
        EXPECT_EQ(efficiencies.extinction, 1.0);
    }
}

TEST(Descartes, BowsAreAsPolarisedAsFresnelSays) {
    // Degree of polarisation and s-fraction of order p alone, in the cell at the bow.
    constexpr double kWithinTheCell = 2e-3;
    const struct {
        int p;
        double degree, s_fraction;
    } rows[] = {{2, 0.92405, 0.96203}, {3, 0.80709, 0.90354}, {4, 0.78040, 0.89020}};
    for (const auto& row : rows) {
        const Angle bow = descartes_ray(kWater, row.p).scattering_angle;
        const std::vector<Angle> theta = {bow - 0.01 * deg, bow, bow + 0.01 * deg};
        std::vector<Intensities> out(3);
        const Drop drop{1.0};
        make_descartes({{row.p}, {}, 0.02})->intensities(kWater, {&drop, 1}, theta, out);
        const double s = out[1].perpendicular, p = out[1].parallel;
        EXPECT_NEAR((s - p) / (s + p), row.degree, kWithinTheCell);
        EXPECT_NEAR(s / (s + p), row.s_fraction, kWithinTheCell);
    }
}

TEST(Descartes, OblateDropsTurnTheirBowsAndLoseNothing) {
    const std::vector<Angle> theta = angles(0.0, 180.0, 0.1);
    const std::vector<Angle> edges = cell_edges(theta);
    Drop round{100.0}, flat{100.0};
    flat.shifts[2] = 1.7 * deg;
    flat.shifts[3] = -0.3 * deg;
    const Drop drops[] = {round, flat};
    for (int p : {2, 3}) {
        std::vector<Intensities> out(2 * theta.size());
        make_descartes({{p}, {}, 0.02})->intensities(kWater, drops, theta, out);
        double energy[2] = {};
        std::size_t brightest[2] = {};
        for (std::size_t d = 0; d < 2; ++d)
            for (std::size_t k = 0; k < theta.size(); ++k) {
                const double value = out[d * theta.size() + k].unpolarised();
                energy[d] += value * cell_solid_angle(edges[k], edges[k + 1]).to(sr);
                const bool near = std::abs((theta[k] - 130.0 * deg).to(deg)) < 20.0;
                if (near && value > out[d * theta.size() + brightest[d]].unpolarised())
                    brightest[d] = k;
            }
        EXPECT_NEAR(energy[1] / energy[0], 1.0, kBalance);
        EXPECT_NEAR((theta[brightest[1]] - theta[brightest[0]]).to(deg),
                    flat.shifts[std::size_t(p)].to(deg), 0.1 + 1e-9);
    }
}

TEST(Descartes, ShiftsOfIntensitiesKeepTheFlux) {
    // An even pattern: ∫ (dΩ₀ / dΩ) dΩ = 4π whatever the shift. Gauss, piece by piece.
    const QuadratureRule rule = gauss_legendre(32);
    for (double shift : {-8.0, 0.5, 3.0}) {
        double sum = 0.0;
        for (double from : {0.0, 30.0, 90.0, 150.0}) {
            const double to = from == 30.0 || from == 90.0 ? from + 60.0 : from + 30.0;
            sum += integrate(rule, from, to, [&](double theta) {
                return brightness_of_shift(theta * deg, shift * deg) * sin(theta * deg) *
                       (1.0 * deg).to(rad);
            });
        }
        EXPECT_NEAR(sum, 2.0, kBalance) << shift;
    }
    // And the same as moving the flux between edges, in small cells.
    const Angle theta = 125.0 * deg, half = 1e-4 * deg;
    const Angle shift = 2.0 * deg;
    const std::vector<Angle> edges = {theta - half, theta + half};
    const std::vector<Angle> moved = {angle_without_shift(edges[0], shift),
                                      angle_without_shift(edges[1], shift)};
    EXPECT_NEAR(cell_solid_angle(moved[0], moved[1]) / cell_solid_angle(edges[0], edges[1]),
                brightness_of_shift(theta, shift), 1e-9);
}

TEST(Descartes, RefusesWhatItCannotTreat) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto model = make_descartes({});
    std::vector<Intensities> out(1);
    const std::vector<Angle> theta = {90.0 * deg};
    const auto ask = [&](ComplexIndex index, double x) {
        const Drop drop{x};
        model->intensities(index, {&drop, 1}, theta, out);
    };
    EXPECT_NO_THROW(ask(kWater, 1.0));
    EXPECT_THROW(ask({1.333, 1e-6}, 1.0), InputError);
    EXPECT_THROW(ask({0.99, 0.0}, 1.0), InputError);
    EXPECT_THROW(ask({2.4, 0.0}, 1.0), InputError);
    for (double x : {0.0, -1.0, nan}) EXPECT_THROW(ask(kWater, x), InputError);
    EXPECT_THROW(make_descartes({{8}, {}, 0.02}), InputError);
    EXPECT_THROW(make_descartes({{-1}, {}, 0.02}), InputError);
    EXPECT_THROW(cell_edges(std::vector<Angle>{30.0 * deg, 30.0 * deg}), InputError);
    EXPECT_THROW(cell_edges(std::vector<Angle>{181.0 * deg}), InputError);
    EXPECT_EQ(make_scattering_model("descartes")->name(), "descartes");
}

}  // namespace
}  // namespace dewbow
