// SPDX-License-Identifier: Apache-2.0

// How fast `auto` makes tables, on one thread, beside Wiscombe's algorithm in the same run: 1801
// angles × 400 wavelengths for drops of 0.5 mm ± 10 %, for which Mie theory needs 100 radii, and
// Lee tables of 300 radii × 601 angles × 80 wavelengths.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "dewbow/base/parallel.h"
#include "dewbow/rainbow/lee_table.h"
#include "dewbow/rainbow/scattering_table.h"
#include "micro/cpu_time.h"
#include "micro/wiscombe_mie.h"

namespace dewbow::bench {
namespace {

using namespace unit;

constexpr int kAngles = 1801, kWavelengths = 400, kRadii = 100, kRepeats = 3;
/// What is asked for.
constexpr double kTargetRatio = 100.0, kTargetSeconds = 2.0;

DropOptics water_in_air() {
    return {make_dispersion({"water", {20.0}, IndexReference::vacuum}), air(), 0.0};
}

std::vector<Wavelength> visible(int count) {
    std::vector<Wavelength> wavelengths;
    for (int i = 0; i < count; ++i) wavelengths.push_back((400.0 + 300.0 * i / (count - 1)) * nm);
    return wavelengths;
}

std::vector<Angle> angles(int count, double from_deg, double to_deg) {
    std::vector<Angle> result;
    for (int i = 0; i < count; ++i)
        result.push_back((from_deg + (to_deg - from_deg) * i / (count - 1)) * deg);
    return result;
}

/// The whole table by Wiscombe's algorithm: its time is proportional to x, so a few sizes tell.
double wiscombe_table_seconds() {
    constexpr int kSizes = 5, kTries = 5;
    std::vector<double> mu(kAngles);
    for (int i = 0; i < kAngles; ++i) mu[std::size_t(i)] = std::cos(std::numbers::pi * i / 1800);
    std::vector<std::complex<double>> S1(mu.size()), S2(mu.size());
    const DropOptics optics = water_in_air();
    double sum = 0.0;
    for (int k = 0; k < kSizes; ++k) {
        const Wavelength lambda = (400.0 + 300.0 * (k + 0.5) / kSizes) * nm;
        const double x = optics.size_parameter(0.5 * mm, lambda);
        sum += least_cpu_seconds(
            kTries, [&] { wiscombe_mie(x, optics.index(lambda).value, mu, false, S1, S2); });
    }
    return sum / kSizes * kWavelengths * kRadii;
}

double table_seconds(const SunDisc& disc, std::string& report) {
    TableRequest request;
    request.sizes = parse_drop_sizes("normal:mean=0.5mm,width=10%");
    request.optics = water_in_air();
    request.wavelengths = visible(kWavelengths);
    request.angles = angles(kAngles, 0.0, 180.0);
    request.disc = disc;
    return least_cpu_seconds(kRepeats, [&] { report = make_scattering_table(request).report; });
}

double lee_seconds(double width, double from_deg, double to_deg, std::string& report) {
    LeeRequest request;
    request.width = width;
    request.optics = water_in_air();
    request.wavelengths = visible(80);
    request.angles = angles(601, from_deg, to_deg);
    for (int i = 0; i < 300; ++i) request.radii.push_back(10.0 * um * std::pow(100.0, i / 299.0));
    return least_cpu_seconds(1, [&] { report = make_lee_table(request).report; });
}

void run() {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    set_thread_count(1);
    const double wiscombe = wiscombe_table_seconds();
    fmt::print("1801 angles x 400 wavelengths x 100 radii around 0.5 mm\n");
    fmt::print("  Wiscombe's algorithm, from a few sizes: {:.1f} s\n", wiscombe);
    std::string report;
    for (const auto& [name, disc] :
         {std::pair{"a point", SunDisc{0.0 * deg, 0.0}}, std::pair{"the sun", SunDisc{}}}) {
        const double seconds = table_seconds(disc, report);
        fmt::print(
            "  auto, {}: {:.2f} s CPU (asked for: {:.0f}), {:.0f} times as fast (asked for: "
            "{:.0f})\n    {}\n",
            name, seconds, kTargetSeconds, wiscombe / seconds, kTargetRatio, report);
    }
    fmt::print("Lee table, 300 radii from 10 um to 1 mm x 601 angles x 80 wavelengths, the sun\n");
    for (const auto& [from, to] : {std::pair{136.0, 148.0}, std::pair{120.0, 150.0}}) {
        const double seconds = lee_seconds(0.05, from, to, report);
        fmt::print(
            "  sizes +- 5 %, {:.0f} to {:.0f} deg: {:.2f} s CPU (asked for: {:.0f})\n    {}\n",
            from, to, seconds, kTargetSeconds, report);
    }
    const double single = lee_seconds(0.0, 136.0, 148.0, report);
    fmt::print("  one size each, 136 to 148 deg: {:.2f} s CPU (asked for: {:.0f})\n    {}\n",
               single, kTargetSeconds, report);
}

}  // namespace
}  // namespace dewbow::bench

int main() { dewbow::bench::run(); }
