// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/angle_grid.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/scattering_table.h"
#include "dewbow/rainbow/sun_disc.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;

DispersionPtr constant(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

std::vector<Angle> angles(double from_deg, double to_deg, double step_deg) {
    std::vector<Angle> result;
    const int count = int(std::lround((to_deg - from_deg) / step_deg));
    for (int k = 0; k <= count; ++k)
        result.push_back((from_deg + (to_deg - from_deg) * k / count) * deg);
    return result;
}

TableRequest request_of(const std::string& sizes, std::vector<Angle> at, Angle disc) {
    TableRequest request;
    request.sizes = parse_drop_sizes(sizes);
    request.optics = {constant(1.333), vacuum(), 0.0};
    request.wavelengths = {589.29 * nm};
    request.angles = std::move(at);
    request.disc.radius = disc;
    return request;
}

struct Peak {
    Angle angle;
    double intensity = 0.0;  ///< (|S_1|² + |S_2|²) / 2x²
    double polarisation = 0.0;
};
Peak peak_between(const ScatteringTable& table, double from_deg, double to_deg) {
    Peak peak;
    for (std::size_t a = 0; a < table.angles.size(); ++a) {
        const double theta = table.angles[a].to(deg);
        const Intensities& P = table.at(a, 0);
        const double intensity = P.unpolarised() * table.efficiencies[0].scattering / 4.0;
        if (theta < from_deg || theta > to_deg || intensity <= peak.intensity) continue;
        peak = {table.angles[a], intensity,
                (P.perpendicular - P.parallel) / (P.perpendicular + P.parallel)};
    }
    return peak;
}

TEST(Automatic, HasTheReferenceValuesOfHalfMillimetreDrops) {
    // Full Mie, n = 1.333, λ = 589.29 nm, a = 0.5 mm ± 10 % by 81 radii, the sun's disc.
    /// Of the peak: its own sampling of radii.
    constexpr double kIntensity = 0.006, kAngle = 0.03, kPolarisation = 0.003;
    const ScatteringTable table = make_scattering_table(
        request_of("normal:mean=0.5mm,width=10%", angles(120.0, 145.0, 0.02), kSunRadius));
    const Peak primary = peak_between(table, 137.0, 145.0);
    EXPECT_NEAR(primary.angle.to(deg), 138.22, kAngle);
    EXPECT_NEAR(primary.intensity, 0.545, kIntensity * 0.545);
    EXPECT_NEAR(primary.polarisation, 0.908, kPolarisation);
    const Peak secondary = peak_between(table, 120.0, 131.0);
    EXPECT_NEAR(secondary.angle.to(deg), 128.58, kAngle);
    EXPECT_NEAR(secondary.intensity, 0.0836, kIntensity * 0.545);
    EXPECT_NEAR(secondary.polarisation, 0.750, kPolarisation);
    double band = 0.0;
    int count = 0;
    for (std::size_t a = 0; a < table.angles.size(); ++a) {
        const double theta = table.angles[a].to(deg);
        if (theta < 131.0 || theta > 136.5) continue;
        band += table.at(a, 0).unpolarised() * table.efficiencies[0].scattering / 4.0;
        ++count;
    }
    EXPECT_NEAR(band / count, 0.0061, kIntensity * 0.545);
}

/// Mie theory at as many radii as it takes, through the same disc. [angle], P without polarisation.
std::vector<double> exact_phase(const TableRequest& request) {
    const Wavelength lambda = request.wavelengths[0];
    SizeSampling sampling;  // steps of 0.7 in x
    sampling.fastest = request.optics.size_parameter(1.0 * m, lambda) / 0.7 / m;
    const Cloud cloud{request.optics, sample_sizes(*request.sizes, sampling), {}};
    AngleGrid grid{request.optics.index(lambda), request.optics.index(lambda)};
    grid.x = request.optics.size_parameter(effective_radius(*request.sizes), lambda);
    grid.parts = 16.0, grid.longest = 0.2 * deg;
    const bool point = request.disc.radius == Angle{};
    const std::vector<Angle> at =
        point ? request.angles : merged_angles(request.angles, adaptive_angles(grid));
    const DropSums sums = scatter_exactly(cloud, lambda, at);
    std::vector<std::size_t> wanted;
    for (const Angle angle : request.angles)
        wanted.push_back(std::size_t(std::lower_bound(at.begin(), at.end(), angle) - at.begin()));
    std::vector<Intensities> smooth(wanted.size());
    SunSmoother(at, request.disc, wanted).apply(sums.intensities, smooth);
    std::vector<double> phase;
    for (const Intensities& each : smooth)
        phase.push_back(4.0 * each.unpolarised() / (sums.x_squared * sums.efficiencies.scattering));
    return phase;
}

struct Difference {
    double error = 0.0;  ///< |ΔP| over the larger of P and the primary bow's peak
    Angle where;
};
double primary_peak(const std::vector<Angle>& at, const std::vector<double>& phase) {
    double peak = 0.0;
    for (std::size_t a = 0; a < at.size(); ++a)
        if (at[a] > 137.0 * deg && at[a] < 155.0 * deg) peak = std::max(peak, phase[a]);
    return peak;
}
Difference largest_difference(const ScatteringTable& table, const std::vector<double>& exact) {
    const double peak = primary_peak(table.angles, exact);
    Difference worst;
    for (std::size_t a = 0; a < exact.size(); ++a) {
        const double error =
            std::abs(table.at(a, 0).unpolarised() - exact[a]) / std::max(peak, exact[a]);
        if (!(error <= worst.error)) worst = {error, table.angles[a]};
    }
    return worst;
}

/// None of these is among the settings of the calibration. The glory itself, whose brightness hangs
/// on resonances of each radius, is left out.
struct Setting {
    const char* sizes;
    double n, lambda_nm;
    Angle disc;
};
void hold_the_tolerance(const Setting& setting) {
    /// Interference between orders that samples of radii leave, in both.
    constexpr double kByChance = 0.003;
    TableRequest request = request_of(setting.sizes, angles(0.0, 178.0, 0.5), setting.disc);
    request.optics.drop = constant(setting.n);
    request.wavelengths = {setting.lambda_nm * nm};
    const ScatteringTable table = make_scattering_table(request);
    EXPECT_LE(table.stated_error, request.tolerance);
    const Difference worst = largest_difference(table, exact_phase(request));
    EXPECT_LE(worst.error, request.tolerance + kByChance)
        << setting.sizes << " at " << worst.where.to(deg) << "; " << table.report;
}
TEST(Automatic, HoldsItsToleranceAgainstMie) {
    hold_the_tolerance({"gamma:mean=18um,width=25%", 1.337, 480.0, kSunRadius});
    hold_the_tolerance({"lognormal:mean=0.1mm,width=7%", 1.340, 430.0, kSunRadius});
}
TEST(LongAutomatic, HoldsItsToleranceAgainstMie) {
    hold_the_tolerance({"gamma:mean=55um,width=15%", 1.331, 650.0, kSunRadius});
    hold_the_tolerance({"gamma:mean=70um,width=30%", 1.334, 550.0, Angle{}});
    hold_the_tolerance({"normal:mean=0.3mm,width=10%", 1.343, 410.0, kSunRadius});
}

TEST(Automatic, IsMieForOneSizeForSmallDropsAndForDarkOnes) {
    const auto mie = make_scattering_model("mie");
    ModelOptions options;
    const std::vector<Angle> at = angles(0.0, 180.0, 10.0);
    const auto differs = [&](ComplexIndex index, double x) {
        const Drop drop{x, {}};
        std::vector<Intensities> a(at.size()), b(at.size());
        make_scattering_model("auto", options)->intensities(index, {&drop, 1}, at, a);
        mie->intensities(index, {&drop, 1}, at, b);
        for (std::size_t k = 0; k < at.size(); ++k)
            if (a[k].parallel != b[k].parallel) return true;
        return false;
    };
    EXPECT_FALSE(differs({1.333, 0.0}, 2000.0));  // one size
    options.averaging = {0.1, kSunRadius};
    EXPECT_FALSE(differs({1.333, 0.0}, 150.0));
    EXPECT_FALSE(differs({1.333, 1e-5}, 2000.0));
    EXPECT_TRUE(differs({1.333, 0.0}, 2000.0));
}

TEST(Automatic, HasNoSeamAndNoSpike) {
    /// Steps of 0.1°; second differences of the primary bow itself reach 1.5 times those of Mie's
    /// own where both are small.
    constexpr double kOfMie = 1.5, kFloor = 2e-3;
    const TableRequest request =
        request_of("normal:mean=0.1mm,width=10%", angles(0.0, 180.0, 0.1), kSunRadius);
    const ScatteringTable table = make_scattering_table(request);
    const std::vector<double> mie = exact_phase(request);
    const double peak = primary_peak(request.angles, mie);
    const auto bend = [](double a, double b, double c) { return std::abs(a - 2.0 * b + c); };
    constexpr std::size_t kBlock = 50;  // 5°
    for (std::size_t from = 1; from + kBlock < mie.size(); from += kBlock) {
        double ours = 0.0, theirs = 0.0, local = peak;
        for (std::size_t a = from; a < from + kBlock; ++a) {
            const auto P = [&](std::size_t k) { return table.at(k, 0).unpolarised(); };
            ours = std::max(ours, bend(P(a - 1), P(a), P(a + 1)));
            theirs = std::max(theirs, bend(mie[a - 1], mie[a], mie[a + 1]));
            local = std::max(local, mie[a]);
        }
        EXPECT_LE(ours, kOfMie * theirs + kFloor * local) << request.angles[from].to(deg);
    }
}

void expect_finite_and_smooth(const char* sizes) {
    /// Bends over steps of 0.05°, of the larger of the value and the peak: the bow's own at 1 mm.
    constexpr double kBend = 0.08;
    const ScatteringTable table =
        make_scattering_table(request_of(sizes, angles(0.0, 180.0, 0.05), kSunRadius));
    std::vector<double> P;
    for (std::size_t a = 0; a < table.angles.size(); ++a) {
        EXPECT_TRUE(std::isfinite(table.at(a, 0).perpendicular));
        EXPECT_GE(table.at(a, 0).perpendicular, 0.0);
        EXPECT_GE(table.at(a, 0).parallel, 0.0);
        P.push_back(table.at(a, 0).unpolarised());
    }
    const double peak = primary_peak(table.angles, P);
    for (std::size_t a = 1; a + 1 < P.size(); ++a) {
        if (table.angles[a] < 3.0 * deg) continue;  // the sun's edge, rings
        EXPECT_LE(std::abs(P[a - 1] - 2.0 * P[a] + P[a + 1]), kBend * std::max(peak, P[a]))
            << sizes << " at " << table.angles[a].to(deg);
    }
}
TEST(Automatic, IsFiniteEverywhere) {
    expect_finite_and_smooth("normal:mean=10um,width=10%");
    expect_finite_and_smooth("normal:mean=1mm,width=10%");
}
TEST(LongAutomatic, IsFiniteEverywhere) {
    expect_finite_and_smooth("normal:mean=30um,width=10%");
    expect_finite_and_smooth("normal:mean=0.2mm,width=20%");
    expect_finite_and_smooth("rain:marshall-palmer,rate=5mm/h");
}

TEST(Automatic, KeepsItsEnergy) {
    /// What the sum of orders may miss, and the trapezoidal rule.
    constexpr double kEnergy = 0.02;
    for (const auto& [disc, falls] :
         {std::pair{0.0 * deg, false}, std::pair{1.0 * kSunRadius, true}}) {
        AngleGrid grid{{1.333}, {1.333}};
        TableRequest request = request_of("normal:mean=0.4mm,width=10%", {}, disc);
        grid.x = request.optics.size_parameter(0.4 * mm, request.wavelengths[0]);
        grid.longest = 0.1 * deg;
        request.angles = adaptive_angles(grid);
        if (falls) request.falling = FallingShape{};
        const ScatteringTable table = make_scattering_table(request);
        double sum = 0.0;
        for (std::size_t a = 1; a < table.angles.size(); ++a)
            sum += 0.5 * (table.at(a, 0).unpolarised() + table.at(a - 1, 0).unpolarised()) *
                   (cos(table.angles[a - 1]) - cos(table.angles[a]));
        EXPECT_NEAR(0.5 * sum, 1.0, kEnergy) << disc.to(deg) << falls;
    }
}

TEST(Automatic, FogbowLiesWhereAirysDoes) {
    // Airy's main maximum for 10 µm is 37.6° from the antisolar point; Mie's differs by less than
    // half of the secondary maximum's distance.
    constexpr double kAiry = 37.6, kWithin = 1.5;
    const ScatteringTable table = make_scattering_table(
        request_of("gamma:mean=10um,width=10%", angles(130.0, 150.0, 0.1), kSunRadius));
    EXPECT_NEAR(180.0 - peak_between(table, 132.0, 148.0).angle.to(deg), kAiry, kWithin);
}

TEST(Automatic, SaysWhatItDid) {
    const ScatteringTable large = make_scattering_table(
        request_of("normal:mean=0.5mm,width=10%", angles(130.0, 140.0, 5.0), kSunRadius));
    EXPECT_NE(large.report.find("sum of orders"), std::string::npos) << large.report;
    EXPECT_GT(large.stated_error, 0.0);
    const ScatteringTable small = make_scattering_table(
        request_of("normal:mean=5um,width=10%", angles(130.0, 140.0, 5.0), kSunRadius));
    EXPECT_EQ(small.report.find("sum of orders"), std::string::npos) << small.report;
    EXPECT_EQ(small.stated_error, 0.0);
}

TEST(Automatic, OrdersAreForLargeDrops) {
    TableRequest request =
        request_of("normal:mean=5um,width=10%", angles(130.0, 140.0, 5.0), kSunRadius);
    request.orders = {2};
    EXPECT_THROW((void)make_scattering_table(request), InputError);
    request.sizes = parse_drop_sizes("normal:mean=0.5mm,width=10%");
    EXPECT_GT(make_scattering_table(request).at(2, 0).perpendicular, 0.0);
    request.orders = {8};
    EXPECT_THROW((void)make_scattering_table(request), InputError);
}

/// The table of automatic_error.cpp against Mie: the sum of orders alone in each region.
TEST(LongAutomatic, ErrorsAreThoseStated) {
    for (const double n : {1.325, 1.333, 1.345})
        for (const double width : {0.05, 0.1, 0.2})
            for (const double x : {250.0, 500.0, 1000.0, 2000.0, 4000.0}) {
                const Length mean = x / (2.0 * kPi) * 589.29e-9 * m;
                TableRequest request = request_of("0.1mm", angles(0.0, 180.0, 0.25), kSunRadius);
                request.sizes = normal_drop_sizes(mean, width);
                request.optics.drop = constant(n);
                request.tolerance = 0.99;
                const ScatteringTable table = make_scattering_table(request);
                const std::vector<double> mie = exact_phase(request);
                const double peak = primary_peak(request.angles, mie);
                const double effective = x * effective_radius(*request.sizes).to(m) / mean.to(m);
                for (const RegionError& region : composition_errors(false)) {
                    const double stated =
                        std::max(region.per_size * 1000.0 / effective, region.least);
                    if (stated >= 1.0) continue;  // left to Mie
                    double worst = 0.0;
                    for (std::size_t a = 0; a < mie.size(); ++a)
                        if (request.angles[a] >= region.range.from &&
                            request.angles[a] <= region.range.to)
                            worst =
                                std::max(worst, std::abs(table.at(a, 0).unpolarised() - mie[a]) /
                                                    std::max(peak, mie[a]));
                    EXPECT_LE(worst, stated) << "n " << n << " width " << width << " x " << x
                                             << " from " << region.range.from.to(deg);
                }
            }
}

}  // namespace
}  // namespace dewbow
